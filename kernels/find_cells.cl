// Where each cell begins and ends in the sorted map (SCCM, eq. 12).

#include "prelude.h"

KERNEL void clear_cells(const StepParameters p, GLOBAL uint2* cell_ranges) {
  const uint cell = work_item();
  if (cell >= p.cells_x * p.cells_y * p.cells_z) return;  // branch: beyond the last cell
  cell_ranges[cell] = make_uint2(0, 0);
}

KERNEL void find_cells(const StepParameters p, GLOBAL const ulong* cell_keys, GLOBAL uint2* cell_ranges) {
  const uint place = work_item();
  if (place >= p.n_particles) return;  // branch: beyond the last particle
  const uint cell = (uint)(cell_keys[place] >> 32);
  if (place == 0 || (uint)(cell_keys[place - 1] >> 32) != cell) {  // branch: first of its cell
    cell_ranges[cell].x = place;
  }
  if (place + 1 == p.n_particles || (uint)(cell_keys[place + 1] >> 32) != cell) {  // branch: last of its cell
    cell_ranges[cell].y = place + 1;
  }
}
