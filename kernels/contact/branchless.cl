// The practical model, eqs. (2)-(10), without a branch in the law: what a lane may need is computed by all,
// and selects take what it does need. Every contact pays for the root and the divisions of one that slips.

#include "contact/contact_law.h"
#include "contact/practical.h"

DEVICE_FUNCTION real3 selected(bool condition, real3 yes, real3 no) {
  return make_real3(condition ? yes.x : no.x, condition ? yes.y : no.y, condition ? yes.z : no.z);
}

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

  const ContactMotion motion = contact_motion(particle, contact);
  const real3 held_displacement = continued_displacement(
      remembered_displacement_without_branches(history, contact->partner), n, &motion, law->time_step);

  real normal_force =
      normal_force_of(normal_stiffness, contact->overlap, damping_coefficient, &motion);  // eq. (4)
#if NORMAL_FORCE == NORMAL_FORCE_REPULSIVE
  normal_force = fmax(normal_force, REAL(0.0));
#endif

  const real friction_limit = parameters.w * fabs(normal_force);
  const real3 spring_force = tangential_spring_force(tangential_stiffness, held_displacement);
  const real3 damping_force = tangential_damping_force(damping_coefficient, &motion);
  const real3 held_force = spring_force + damping_force;  // eq. (4)
  const real3 tested_force = tested_by_friction(spring_force, held_force);
  const real tested_square = dot(tested_force, tested_force);
  const bool slips = tested_square > friction_limit * friction_limit;
  // Of a contact that holds, whatever finite number.
  const real3 cut_force =
      tested_force * quotient(friction_limit, square_root(fmax(tested_square, SMALL_REAL)));  // eq. (5)
  const real3 tangential_force = selected(slips, cut_force, held_force);
#if SLIP_HISTORY == SLIP_HISTORY_PAPER
  const real3 tangential_displacement = held_displacement;
#else
  const real3 cut_displacement =
      -held_by_spring(cut_force, damping_force) * quotient(REAL(1.0), fmax(tangential_stiffness, SMALL_REAL));
  const real3 tangential_displacement =
      selected(slips & (tangential_stiffness > REAL(0.0)), cut_displacement, held_displacement);
#endif
  remember_displacement(history, contact->partner, tangential_displacement);
  add_contact(sum, particle, n, normal_force, tangential_force);
}
