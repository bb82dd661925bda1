// The forces between particles from lists of groups, as molecular-dynamics codes keep them: the particles are
// cut into groups of eight in the order of the sorted map, and for each group those groups are listed that
// have a particle near one of its own, with a bit for each such particle. Lists last as those of verlet.cl
// do, and are an eighth as many. All lanes of a group walk its list together and load the same candidate.

// Particles of a group may lie anywhere from those of another: a row of cells ends at one side of the grid,
// and the next begins at the other.
#define FAR_PAIRS
#include "contact/contact_law.h"
#include "pair.h"
#include "particle_access.h"
#include "prelude.h"
#include "search/candidates.h"

#ifndef GROUP_SLOTS
#define GROUP_SLOTS 128
#endif

DEVICE_FUNCTION uint n_groups(const StepParameters p) {
  return (p.n_particles + GROUP_SIZE - 1) / GROUP_SIZE;
}

// Notes the particle at `place` of the map in the list of `group`, which is `length` long, and returns how
// long the list is then. Entry k at near_groups[k * n_groups + group]: the number of a group above its bits.
DEVICE_FUNCTION uint note_particle(const StepParameters p, uint group, uint place, uint length,
                                   GLOBAL uint* near_groups) {
  const uint near_group = place / GROUP_SIZE, bit = 1u << place % GROUP_SIZE;
  uint k = length;
  while (k > 0) {  // branch: next noted group
    GLOBAL uint* entry = &near_groups[(k - 1) * n_groups(p) + group];
    if (*entry >> GROUP_SIZE == near_group) {  // branch: noted group
      *entry |= bit;
      return length;
    }
    --k;
  }
  if (length < GROUP_SLOTS) near_groups[length * n_groups(p) + group] = near_group << GROUP_SIZE | bit;
  return length + 1;
}

// A work-item a group.
KERNEL void list_groups(const StepParameters p MAP_PARAMETER, GLOBAL const uint2* cell_ranges,
                        GLOBAL const Place* position_radius, GLOBAL const Identity* rank_material,
                        GLOBAL uint* near_groups, GLOBAL uint* near_counts, GLOBAL Place* listed_positions,
                        GLOBAL uint* lists_outdated, GLOBAL uint* status) {
  const uint group = work_item();
  if (group == 0) *lists_outdated = 0;
  if (group >= n_groups(p)) return;  // branch: beyond the last group
  uint length = 0;
  const uint end = min((group + 1) * GROUP_SIZE, p.n_particles);
  for (uint member = group * GROUP_SIZE; member < end; ++member) {  // branch: next of group
    const uint self = particle_at(member MAP_ARGUMENT);
    Particle particle;
    load_place(p, position_radius[self], rank_material[self], &particle);
    listed_positions[self] = position_radius[self];
    const Cell cell = cell_at(p, position_radius[self]);
    for (int z = max(cell.z - 1, 0); z <= min(cell.z + 1, (int)p.cells_z - 1); ++z) {    // branch: next layer
      for (int y = max(cell.y - 1, 0); y <= min(cell.y + 1, (int)p.cells_y - 1); ++y) {  // branch: next row
        for (int s = 0; s < STRETCHES; ++s) {
          const uint2 stretch = stretch_from(p, cell.x - 1 + s, y, z, cell_ranges);
          for (uint place = stretch.x; place < stretch.y; ++place) {  // branch: next candidate
            const Pair pair = pair_with(particle.place, position_radius[particle_at(place MAP_ARGUMENT)]);
            if (place != member && is_within(&pair, p.skin))  // branch: near enough
              length = note_particle(p, group, place, length, near_groups);
            if (length > GROUP_SLOTS) {  // branch: list full
              report_error(status, STATUS_LIST_FULL, particle.rank);
              length = GROUP_SLOTS;
            }
          }
        }
      }
    }
  }
  near_counts[group] = length;
}

KERNEL void force_between_particles(const StepParameters p MAP_PARAMETER, GLOBAL const uint* near_groups,
                                    GLOBAL const uint* near_counts, GLOBAL uint* near,
                                    PARTICLE_PARAMETERS MATERIAL_PARAMETER, SUM_PARAMETERS,
                                    GLOBAL uint2* contact_counts, GLOBAL uint* status HISTORY_PARAMETERS) {
  const uint member = work_item();
  if (member >= p.n_particles) return;  // branch: beyond the last particle
  const uint self = particle_at(member MAP_ARGUMENT), group = member / GROUP_SIZE;
  const Particles particles = PARTICLES;
  const Sums sums = SUMS;
  const Particle particle = load_particle(p, self, &particles);

  uint n_contacts = 0;
  const uint length = near_counts[group];
  for (uint k = 0; k < length; ++k) {  // branch: next group
    const uint entry = near_groups[k * n_groups(p) + group];
    const uint first = (entry >> GROUP_SIZE) * GROUP_SIZE;
    for (uint bits = entry & 0xFF; bits != 0; bits &= bits - 1) {  // branch: next candidate
      const uint other = particle_at(first + lowest_bit(bits) MAP_ARGUMENT);
      const Pair pair = pair_with(particle.place, position_radius[other]);
      const bool is_contact = touches(&pair) && other != self;
      if (is_contact && n_contacts < LIST_SLOTS) {  // branch: near enough
        near[n_contacts * p.n_particles + self] = other;
      }
      n_contacts += is_contact ? 1 : 0;
    }
  }
  n_contacts = checked_length(n_contacts, &particle, status);

  const LawParameters law = LAW_PARAMETERS(p, of_pairs);
  ContactHistory history = HISTORY_OF(self, particle.rank, 0);
  ForceSum sum = gravity_alone(p, particle.mass);
  apply_to_listed(p, self, &particle, n_contacts, near, &particles, &law, &history, &sum);
  store_sum(self, &particles, &sum, n_contacts, &sums, contact_counts, status);
}
