// Where particles do not stand in memory as they do in the sorted map, the map says where they are: ranks in
// its keys become places in the arrays. For searches that is what the ranks of order `unsorted` are.

#include "prelude.h"

KERNEL void point_map(const StepParameters p, GLOBAL const uint* particle_of_rank, GLOBAL ulong* cell_keys) {
  const uint place = work_item();
  if (place >= p.n_particles) return;  // branch: beyond the last particle
  const ulong key = cell_keys[place];
  cell_keys[place] = (key >> 32 << 32) | particle_of_rank[(uint)key];
}
