// The forces from walls, which continue what the forces between particles began: their sums and contact
// slots. A wall is a particle of infinite radius and infinite mass at rest; a rectangle is touched at its
// nearest point, so edges and corners work.

#include "contact/contact_law.h"
#include "particle_access.h"
#include "prelude.h"
#include "wall.h"

KERNEL void force_from_walls(const StepParameters p, CONSTANT const Wall* walls,
                             PARTICLE_PARAMETERS MATERIAL_PARAMETER, SUM_PARAMETERS,
                             GLOBAL uint2* contact_counts, GLOBAL uint* status HISTORY_PARAMETERS) {
  const uint self = work_item();
  if (self >= p.n_particles) return;  // branch: beyond the last particle
  const Particles particles = PARTICLES;
  const Sums sums = SUMS;
  const Particle particle = load_particle(p, self, &particles);
  const LawParameters law = LAW_PARAMETERS(p, of_walls);
  const uint n_particles_touched = contact_counts[self].x;
  ContactHistory history = HISTORY_OF(self, particle.rank, min(n_particles_touched, (uint)CONTACT_SLOTS));
  ForceSum sum = load_forces(self, &sums);
  uint n_contacts = 0;

  for (uint index = 0; index < N_WALLS; ++index) {  // branch: next wall
    CONSTANT const Wall* wall = &walls[index];
    Touch touch;
    if (is_rectangle(wall)) {                                        // branch: rectangle
      if (!touch_rectangle(wall, particle.place, &touch)) continue;  // branch: rectangle contact test
    } else {
      if (!touch_plane(wall, particle.place, &touch)) continue;  // branch: plane contact test
    }
    Contact contact;
    contact.contact_normal = touch.contact_normal;
    contact.overlap = touch.overlap;
    contact.velocity = make_real3(REAL(0.0), REAL(0.0), REAL(0.0));
    contact.surface_rotation = make_real3(REAL(0.0), REAL(0.0), REAL(0.0));
    contact.inverse_radius = REAL(0.0);
    contact.inverse_mass = REAL(0.0);
    contact.radius = particle.radius;
    contact.mass = particle.mass;
    contact.radius_ratio = REAL(1.0);
    contact.mass_ratio = REAL(1.0);
    contact.partner = WALL_PARTNER_BIT | index;
    contact.material = wall->material;
    apply_contact(&law, &particle, &contact, &history, &sum);
    ++n_contacts;
  }

  check_sum(&sum, particle.rank, status);  // the evaluation is complete here
  store_forces(self, &sum, &sums);
  contact_counts[self] = make_uint2(n_particles_touched, n_contacts);
}
