// The forces between particles. Each work-item walks the 27 cells around its particle; the law is any
// of contact/.

#include "contact/contact_law.h"
#include "grid.h"
#include "pair.h"
#include "particle_access.h"
#include "prelude.h"

KERNEL void force_between_particles(const StepParameters p MAP_PARAMETER, GLOBAL const uint2* cell_ranges,
                                    PARTICLE_PARAMETERS MATERIAL_PARAMETER, SUM_PARAMETERS,
                                    GLOBAL uint2* contact_counts, GLOBAL uint* status HISTORY_PARAMETERS) {
  const uint self = work_item();
  if (self >= p.n_particles) return;  // branch: beyond the last particle
  const Particles particles = PARTICLES;
  const Sums sums = SUMS;
  const Particle particle = load_particle(p, self, &particles);
  const LawParameters law = LAW_PARAMETERS(p, of_pairs);
  ContactHistory history = HISTORY_OF(self, particle.rank, 0);
  ForceSum sum = gravity_alone(p, particle.mass);
  uint n_contacts = 0;

  const Cell cell = cell_at(p, position_radius[self]);
  for (int z = max(cell.z - 1, 0); z <= min(cell.z + 1, (int)p.cells_z - 1); ++z) {      // branch: next layer
    for (int y = max(cell.y - 1, 0); y <= min(cell.y + 1, (int)p.cells_y - 1); ++y) {    // branch: next row
      for (int x = max(cell.x - 1, 0); x <= min(cell.x + 1, (int)p.cells_x - 1); ++x) {  // branch: next cell
        const uint2 range = cell_ranges[cell_number(p, x, y, z)];
        for (uint place = range.x; place < range.y; ++place) {  // branch: next candidate
          const uint other = particle_at(place MAP_ARGUMENT);
          if (other == self) continue;  // branch: self
          const Pair pair = pair_with(particle.place, position_radius[other]);
          if (touches(&pair)) {  // branch: contact test
            const Contact contact = contact_of(&particle, &pair, other, &particles);
            apply_contact(&law, &particle, &contact, &history, &sum);
            ++n_contacts;
          }
        }
      }
    }
  }

  store_sum(self, &particles, &sum, n_contacts, &sums, contact_counts, status);
}
