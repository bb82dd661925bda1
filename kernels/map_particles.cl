// The correspondence map CM (eq. 11), one key (cell, rank) a particle. Ties between particles of a
// cell are broken by rank, so that the sorted map, and with it the order of every sum of forces, depends on
// nothing but the particles.

#include "grid.h"
#include "prelude.h"

KERNEL void map_particles(const StepParameters p, GLOBAL const Place* position_radius,
                          GLOBAL const Identity* rank_material, GLOBAL ulong* cell_keys,
                          GLOBAL uint* particle_of_rank, GLOBAL uint* status) {
  const uint particle = work_item();
  if (particle >= p.n_keys) return;
  if (particle >= p.n_particles) {  // branch: padding
    cell_keys[particle] = ~(ulong)0;
    return;
  }
  const uint rank = rank_in(rank_material[particle]);
  const Place place = position_radius[particle];

  uint cell_of_particle = 0;
  if (is_inside(p, place, rank, status)) {  // branch: inside the domain
    const Cell cell = cell_at(p, place);
    cell_of_particle = cell_number(p, cell.x, cell.y, cell.z);
  }
  cell_keys[particle] = ((ulong)cell_of_particle << 32) | rank;
  particle_of_rank[rank] = particle;
}
