// Where each cell begins and ends in the sorted map (SCCM, eq. 12).

#include "prelude.h"

// The (begin, end) pairs of `cell_ranges` are written as single numbers: a compiler may store one component
// of a uint2 by loading, changing and storing both, and the two components belong to two work-items.

KERNEL void clear_cells(const StepParameters p, GLOBAL uint* cell_ranges) {
  const uint cell = work_item();
  if (cell >= p.n_cells) return;  // branch: beyond the last cell
  cell_ranges[2 * cell] = 0;
  cell_ranges[2 * cell + 1] = 0;
}

KERNEL void find_cells(const StepParameters p, GLOBAL const ulong* cell_keys, GLOBAL uint* cell_ranges) {
  const uint place = work_item();
  if (place >= p.n_particles) return;  // branch: beyond the last particle
  const uint cell = (uint)(cell_keys[place] >> 32);
  if (place == 0 || (uint)(cell_keys[place - 1] >> 32) != cell) {  // branch: first of its cell
    cell_ranges[2 * cell] = place;
  }
  if (place + 1 == p.n_particles || (uint)(cell_keys[place + 1] >> 32) != cell) {  // branch: last of its cell
    cell_ranges[2 * cell + 1] = place + 1;
  }
}
