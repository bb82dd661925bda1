// The collision grid: cells not smaller than the largest diameter, so that partners are at most one cell
// away.
#ifndef WARPGRAIN_GRID_H
#define WARPGRAIN_GRID_H

#include "prelude.h"

typedef struct {
  int x, y, z;
} Cell;

DEVICE_FUNCTION int cell_along(real offset, real inverse_cell_size, uint n) {
  return clamp((int)(offset * inverse_cell_size), 0, (int)n - 1);
}

// The cell of a place inside the domain.
DEVICE_FUNCTION Cell cell_at(const StepParameters p, real4 place) {
  Cell cell;
  cell.x = cell_along(place.x - p.lower.x, p.inverse_cell_size, p.cells_x);
  cell.y = cell_along(place.y - p.lower.y, p.inverse_cell_size, p.cells_y);
  cell.z = cell_along(place.z - p.lower.z, p.inverse_cell_size, p.cells_z);
  return cell;
}

DEVICE_FUNCTION uint cell_number(const StepParameters p, int x, int y, int z) {
  return ((uint)z * p.cells_y + (uint)y) * p.cells_x + (uint)x;
}

#endif
