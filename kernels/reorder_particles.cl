// Moves all properties of the particles into the order of the sorted map, or of other keys with their ranks,
// the contact history included.

#include "contact_history.h"
#include "prelude.h"

#if HAS_ROTATION
#define ROTATION_MOVE_PARAMETERS , GLOBAL const real4 *angular_velocity_in, GLOBAL real4 *angular_velocity
#else
#define ROTATION_MOVE_PARAMETERS
#endif
#if CONTACT_SLOTS > 0
#define HISTORY_MOVE_PARAMETERS                                                               \
  , GLOBAL const uint2 *counts_in, GLOBAL const uint *partners_in,                            \
      GLOBAL const StoredReal *displacements_in, GLOBAL uint2 *counts, GLOBAL uint *partners, \
      GLOBAL StoredReal *displacements
#else
#define HISTORY_MOVE_PARAMETERS
#endif

KERNEL void reorder_particles(
    const StepParameters p, GLOBAL const ulong* keys, GLOBAL uint* particle_of_rank,
    GLOBAL const Place* position_radius_in, GLOBAL const real4* velocity_mass_in,
    GLOBAL const Identity* rank_material_in, GLOBAL Place* position_radius, GLOBAL real4* velocity_mass,
    GLOBAL Identity* rank_material ROTATION_MOVE_PARAMETERS HISTORY_MOVE_PARAMETERS) {
  const uint place = work_item();
  if (place >= p.n_particles) return;  // branch: beyond the last particle
  const uint rank = (uint)keys[place], origin = particle_of_rank[rank];
  particle_of_rank[rank] = place;

  position_radius[place] = position_radius_in[origin];
  velocity_mass[place] = velocity_mass_in[origin];
  rank_material[place] = rank_material_in[origin];
#if HAS_ROTATION
  angular_velocity[place] = angular_velocity_in[origin];
#endif

#if CONTACT_SLOTS > 0
  const uint2 count = counts_in[origin];
  counts[place] = count;
  for (uint slot = 0; slot < used_slots(count); ++slot) {  // branch: used contact slots
    partners[place * CONTACT_SLOTS + slot] = partners_in[origin * CONTACT_SLOTS + slot];
    store_displacement(load_displacement(origin * CONTACT_SLOTS + slot, displacements_in),
                       place * CONTACT_SLOTS + slot, displacements);
  }
#endif
}
