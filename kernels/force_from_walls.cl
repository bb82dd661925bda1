// The forces from walls, which continue what the forces between particles began: their sums and contact
// slots. A wall is a particle of infinite radius and infinite mass at rest; a rectangle is touched at its
// nearest point, so edges and corners work.

#include "contact/contact_law.h"
#include "particle_access.h"
#include "prelude.h"
#include "wall.h"

KERNEL void force_from_walls(const StepParameters p, CONSTANT const Wall* walls,
                             GLOBAL const Place* position_radius, GLOBAL const real4* velocity_mass,
                             GLOBAL const real4* angular_velocity, GLOBAL const uint2* rank_material,
                             CONSTANT const real4* contact_parameters, GLOBAL real4* force,
                             GLOBAL real4* torque, GLOBAL uint2* contact_counts,
                             GLOBAL uint* status HISTORY_PARAMETERS) {
  const uint self = work_item();
  if (self >= p.n_particles) return;  // branch: beyond the last particle
  const Particle particle =
      load_particle(self, position_radius, velocity_mass, angular_velocity, rank_material);
  const LawParameters law = law_parameters(p, contact_parameters);
  const uint n_particles_touched = contact_counts[self].x;
  ContactHistory history = HISTORY_OF(self, particle.rank, min(n_particles_touched, (uint)CONTACT_SLOTS));
  ForceSum sum;
  sum.force = xyz(force[self]);
  sum.torque = xyz(torque[self]);
  uint n_contacts = 0;

  for (uint index = 0; index < p.n_walls; ++index) {  // branch: next wall
    CONSTANT const Wall* wall = &walls[index];
    Touch touch;
    if (wall->is_rectangle) {                                        // branch: rectangle
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

  // The evaluation is complete here: nothing that is not a number goes further unnoticed.
  const real3 check = sum.force + sum.torque;
  if (!is_finite(check.x + check.y + check.z)) report_error(status, STATUS_NOT_FINITE, particle.rank);
  force[self] = make_real4(sum.force, REAL(0.0));
  torque[self] = make_real4(sum.torque, REAL(0.0));
  contact_counts[self] = make_uint2(n_particles_touched, n_contacts);
}
