// The practical model, eqs. (2)-(10), with its natural branches.

#include "contact/contact_law.h"
#include "contact/practical.h"

DEVICE_FUNCTION void apply_contact(const LawParameters* law, const Particle* particle, const Contact* contact,
                                   ContactHistory* history, ForceSum* sum) {
  const real4 parameters = parameters_of(law, particle, contact);
  const real3 n = contact->contact_normal;
  const real effective_radius = effective_radius_of(law, particle, contact);
  const real effective_mass = effective_mass_of(law, particle, contact);
  const real contact_radius = square_root(contact->overlap * effective_radius);
  const real normal_stiffness = parameters.x * contact_radius;                                     // eq. (8)
  const real tangential_stiffness = parameters.y * contact_radius;                                 // eq. (9)
  const real damping_coefficient = parameters.z * square_root(normal_stiffness * effective_mass);  // eq. (10)
  const real friction_coefficient = parameters.w;

  const ContactMotion motion = contact_motion(particle, contact);
  real3 tangential_displacement =
      continued_displacement(remembered_displacement(history, contact->partner), n, &motion, law->time_step);

  real normal_force =
      normal_force_of(normal_stiffness, contact->overlap, damping_coefficient, &motion);  // eq. (4)
#if NORMAL_FORCE == NORMAL_FORCE_REPULSIVE
  if (normal_force < REAL(0.0)) normal_force = REAL(0.0);  // branch: pulling
#endif

  const real friction_limit = friction_coefficient * fabs(normal_force);
  const real3 spring_force = tangential_spring_force(tangential_stiffness, tangential_displacement);
  const real3 damping_force = tangential_damping_force(damping_coefficient, &motion);
  real3 tangential_force = spring_force + damping_force;  // eq. (4)
  const real3 tested_force = tested_by_friction(spring_force, tangential_force);
  const real tested_square = dot(tested_force, tested_force);
  if (tested_square > friction_limit * friction_limit) {                                     // branch: slip
    tangential_force = tested_force * quotient(friction_limit, square_root(tested_square));  // eq. (5)
#if SLIP_HISTORY != SLIP_HISTORY_PAPER
    if (tangential_stiffness > REAL(0.0)) {  // branch: tangential spring
      tangential_displacement =
          -quotient_of_vector(held_by_spring(tangential_force, damping_force), tangential_stiffness);
    }
#endif
  }
  remember_displacement(history, contact->partner, tangential_displacement);
  add_contact(sum, particle, n, normal_force, tangential_force);
}
