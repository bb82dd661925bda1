// The collision grid: cells not smaller than the largest diameter, so that partners are at most one cell
// away.
#ifndef WARPGRAIN_GRID_H
#define WARPGRAIN_GRID_H

#include "place.h"
#include "prelude.h"
#include "status.h"

typedef struct {
  int x, y, z;
} Cell;

DEVICE_FUNCTION int cell_along(real offset, real inverse_cell_size, uint n) {
  return clamp((int)(offset * inverse_cell_size), 0, (int)n - 1);
}

// The cell of a place inside the domain.
DEVICE_FUNCTION Cell cell_at(const StepParameters p, Place place) {
  Cell cell;
  cell.x = cell_along(length_between(p.lower.x, place.x), p.inverse_cell_size, p.cells_x);
  cell.y = cell_along(length_between(p.lower.y, place.y), p.inverse_cell_size, p.cells_y);
  cell.z = cell_along(length_between(p.lower.z, place.z), p.inverse_cell_size, p.cells_z);
  return cell;
}

// The order axis: 1, cells are numbered along a Morton curve in tiles of 8 x 8 x 8; 0, row by row.
#ifndef ORDER_MORTON
#define ORDER_MORTON 0
#endif
// 1, the arrays are in the order of the sorted map; 0, they are in the order of ranks.
#ifndef ORDER_CELL
#define ORDER_CELL 1
#endif

#if ORDER_MORTON
// The three bits of `v`, two zeros between them.
DEVICE_FUNCTION uint spread_bits(uint v) { return (v & 1) | (v & 2) << 2 | (v & 4) << 4; }

DEVICE_FUNCTION uint cell_number(const StepParameters p, int x, int y, int z) {
  const uint tiles_x = (p.cells_x + 7) / 8, tiles_y = (p.cells_y + 7) / 8;
  const uint tile = ((uint)z / 8 * tiles_y + (uint)y / 8) * tiles_x + (uint)x / 8;
  return tile * 512 + (spread_bits(x) | spread_bits(y) << 1 | spread_bits(z) << 2);
}
#else
DEVICE_FUNCTION uint cell_number(const StepParameters p, int x, int y, int z) {
  return ((uint)z * p.cells_y + (uint)y) * p.cells_x + (uint)x;
}
#endif

// The sorted map, for the kernels that find particles through it.
#if ORDER_CELL
#define MAP_PARAMETER
#define MAP_ARGUMENT
#else
#define MAP_PARAMETER , GLOBAL const ulong* cell_keys
#define MAP_ARGUMENT , cell_keys
#endif

// The particle at a place of the sorted map.
DEVICE_FUNCTION uint particle_at(uint place MAP_PARAMETER) {
#if ORDER_CELL
  return place;
#else
  return (uint)cell_keys[place];
#endif
}

// Reports a particle that has left the domain or the numbers; false for one that has. Written so that a NaN
// fails it.
DEVICE_FUNCTION bool is_inside(const StepParameters p, Place place, uint rank, GLOBAL uint* status) {
  const bool inside = place.x >= p.lower.x && place.x <= p.upper.x && place.y >= p.lower.y &&
                      place.y <= p.upper.y && place.z >= p.lower.z && place.z <= p.upper.z;
  if (!inside) {  // branch: outside the domain
    report_error(status, is_a_place(place) ? STATUS_OUT_OF_DOMAIN : STATUS_NOT_FINITE, rank);
  }
  return inside;
}

#endif
