// The forces between particles from neighbour lists with a skin: all particles whose surfaces were nearer
// than it when the lists were made. They are complete until some particle has moved half the skin; the host
// looks at every step whether one has, before the lists are used.

#include "contact/contact_law.h"
#include "pair.h"
#include "particle_access.h"
#include "prelude.h"
#include "search/candidates.h"

KERNEL void list_neighbours(const StepParameters p MAP_PARAMETER, GLOBAL const uint2* cell_ranges,
                            GLOBAL const Place* position_radius, GLOBAL const Identity* rank_material,
                            GLOBAL uint* near, GLOBAL uint* near_counts, GLOBAL Place* listed_positions,
                            GLOBAL uint* lists_outdated, GLOBAL uint* status) {
  const uint self = work_item();
  if (self == 0) *lists_outdated = 0;
  if (self >= p.n_particles) return;  // branch: beyond the last particle
  Particle particle;
  load_place(p, position_radius[self], rank_material[self], &particle);
  near_counts[self] =
      list_near(p, self, &particle, p.skin MAP_ARGUMENT, cell_ranges, position_radius, near, status);
  listed_positions[self] = position_radius[self];
}

// Which of the listed neighbours touch goes into a word of bits, 32 at a time, so that no lane waits in the
// law for a lane whose neighbour does not touch.
KERNEL void force_between_particles(const StepParameters p, GLOBAL const uint* near,
                                    GLOBAL const uint* near_counts, PARTICLE_PARAMETERS MATERIAL_PARAMETER,
                                    SUM_PARAMETERS, GLOBAL uint2* contact_counts,
                                    GLOBAL uint* status HISTORY_PARAMETERS) {
  const uint self = work_item();
  if (self >= p.n_particles) return;  // branch: beyond the last particle
  const Particles particles = PARTICLES;
  const Sums sums = SUMS;
  const Particle particle = load_particle(p, self, &particles);
  const LawParameters law = LAW_PARAMETERS(p, of_pairs);
  ContactHistory history = HISTORY_OF(self, particle.rank, 0);
  ForceSum sum = gravity_alone(p, particle.mass);
  uint n_contacts = 0;

  const uint n_near = near_counts[self];
  for (uint first = 0; first < n_near; first += 32) {  // branch: next 32 neighbours
    const uint n = min(n_near - first, 32u);
    uint touching = 0;
    for (uint k = 0; k < n; ++k) {  // branch: next neighbour
      const Pair pair = pair_with(particle.place, position_radius[near[(first + k) * p.n_particles + self]]);
      touching |= touches(&pair) ? 1u << k : 0;
    }
    while (touching != 0) {  // branch: next contact
      const uint k = lowest_bit(touching);
      touching &= touching - 1;
      const uint other = near[(first + k) * p.n_particles + self];
      const Pair pair = pair_with(particle.place, position_radius[other]);
      const Contact contact = contact_of(&particle, &pair, other, &particles);
      apply_contact(&law, &particle, &contact, &history, &sum);
      ++n_contacts;
    }
  }

  store_sum(self, &particles, &sum, n_contacts, &sums, contact_counts, status);
}
