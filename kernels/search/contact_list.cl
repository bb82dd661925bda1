// The forces between particles with a work-item a contact: the particles of a work-group list their contacts,
// which are then numbered through, and contact after contact goes to the next work-item, whoever's it is.
// Only the last round of a work-group has lanes without a contact. The particles add up what their contacts
// gave in the order of their lists, so that sums are the same at every run.

#include "contact/contact_law.h"
#include "pair.h"
#include "particle_access.h"
#include "prelude.h"
#include "search/candidates.h"
#include "search/numbering.h"

// What the contacts of a round gave: all forces, then all torques.
DEVICE_FUNCTION void store_result(LOCAL_POINTER real* results, uint item, const ForceSum* of_contact) {
  vstore3(of_contact->force, item, results);
#if HAS_ROTATION
  vstore3(of_contact->torque, PARTICLE_WORK_GROUP + item, results);
#endif
}
DEVICE_FUNCTION void add_result(LOCAL_POINTER const real* results, uint item, ForceSum* sum) {
  sum->force += vload3(item, results);
#if HAS_ROTATION
  sum->torque += vload3(PARTICLE_WORK_GROUP + item, results);
#endif
}

KERNEL WORK_GROUP_OF(PARTICLE_WORK_GROUP) void force_between_particles(
    const StepParameters p MAP_PARAMETER, GLOBAL const uint2* cell_ranges, GLOBAL uint* near,
    PARTICLE_PARAMETERS MATERIAL_PARAMETER, SUM_PARAMETERS, GLOBAL uint2* contact_counts,
    GLOBAL uint* status HISTORY_PARAMETERS) {
  LOCAL uint ends[PARTICLE_WORK_GROUP];
  LOCAL real results[SUM_REALS * PARTICLE_WORK_GROUP];
  const uint self = work_item(), item = work_item_in_group(), first_particle = self - item;
  const bool exists = self < p.n_particles;
  const Particles particles = PARTICLES;
  const Sums sums = SUMS;
  ForceSum sum;
  uint n_contacts = 0;
  if (exists) {  // branch: a particle
    const Particle particle = load_particle(p, self, &particles);
    n_contacts =
        list_near(p, self, &particle, REAL(0.0) MAP_ARGUMENT, cell_ranges, position_radius, near, status);
    sum = gravity_alone(p, particle.mass);
  }
  ends[item] = n_contacts;
  work_group_barrier_all();  // the lists are read by others
  sum_up(ends, item, PARTICLE_WORK_GROUP);
  const uint n_in_group = ends[PARTICLE_WORK_GROUP - 1];
  const uint end = ends[item], begin = end - n_contacts;

  const LawParameters law = LAW_PARAMETERS(p, of_pairs);
  for (uint first = 0; first < n_in_group; first += PARTICLE_WORK_GROUP) {  // branch: next round
    const uint number = first + item;
    if (number < n_in_group) {  // branch: a contact
      const uint owner = owner_of(number, ends, PARTICLE_WORK_GROUP);
      const uint k = number_within(number, owner, ends), index = first_particle + owner;
      const Particle particle = load_particle(p, index, &particles);
      const uint other = near[k * p.n_particles + index];
      const Pair pair = pair_with(particle.place, position_radius[other]);
      const Contact contact = contact_of(&particle, &pair, other, &particles);
      ContactHistory history = HISTORY_OF(index, particle.rank, k);
      ForceSum of_contact = no_sum();
      apply_contact(&law, &particle, &contact, &history, &of_contact);
      store_result(results, item, &of_contact);
    }
    work_group_barrier_local();
    const uint last = min(end, first + PARTICLE_WORK_GROUP);
    for (uint contact = max(begin, first); contact < last; ++contact) {  // branch: next result
      add_result(results, contact - first, &sum);
    }
    work_group_barrier_local();
  }

  if (!exists) return;  // branch: beyond the last particle
  store_sum(self, &particles, &sum, n_contacts, &sums, contact_counts, status);
}
