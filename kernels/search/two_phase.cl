// The forces between particles in two phases: each work-item first lists the partners that it touches, then
// applies the law to one after the other, so that no lane waits in the law for a lane without a contact.

#include "contact/contact_law.h"
#include "pair.h"
#include "particle_access.h"
#include "prelude.h"
#include "search/candidates.h"

KERNEL void force_between_particles(const StepParameters p MAP_PARAMETER, GLOBAL const uint2* cell_ranges,
                                    GLOBAL uint* near, PARTICLE_PARAMETERS MATERIAL_PARAMETER, SUM_PARAMETERS,
                                    GLOBAL uint2* contact_counts, GLOBAL uint* status HISTORY_PARAMETERS) {
  const uint self = work_item();
  if (self >= p.n_particles) return;  // branch: beyond the last particle
  const Particles particles = PARTICLES;
  const Sums sums = SUMS;
  const Particle particle = load_particle(p, self, &particles);
  const uint n_contacts =
      list_near(p, self, &particle, REAL(0.0) MAP_ARGUMENT, cell_ranges, position_radius, near, status);

  const LawParameters law = LAW_PARAMETERS(p, of_pairs);
  ContactHistory history = HISTORY_OF(self, particle.rank, 0);
  ForceSum sum = gravity_alone(p, particle.mass);
  apply_to_listed(p, self, &particle, n_contacts, near, &particles, &law, &history, &sum);
  store_sum(self, &particles, &sum, n_contacts, &sums, contact_counts, status);
}
