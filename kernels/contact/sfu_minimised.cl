// The practical model, eqs. (2)-(10), with as few operations on the special-function unit as its algebra
// allows: a reciprocal square root for distance and normal, one for the stiffness, and two operations more in
// a contact that slips. A root of a quotient a / b is a rsqrt(a b), which gives the inverse of the root as
// well.

#define ONE_ROOT_A_PAIR
#include "contact/contact_law.h"
#include "contact/practical.h"

// 1 / sqrt(x), for the root that is left, of eq. (10). The seed is a known bit trick (C. Lomont, "Fast
// inverse square root", 2003), 3.4 % off; a step of third and one of second order leave 1e-7. Finite at 0.
// Double has no approximation in hardware to save.
DEVICE_FUNCTION real inverse_root_by_multiplication(real x) {
#if REAL_BITS == 32
  real y = real_of_bits(0x5f375a86u - (bits_of(x) >> 1));
  const real r = x * y * y;
  y *= fma(r, fma(r, REAL(0.375), REAL(-1.25)), REAL(1.875));
  return y * fma(REAL(-0.5) * x * y, y, REAL(1.5));
#else
  return reciprocal_square_root(fmax(x, SMALL_REAL));
#endif
}

DEVICE_FUNCTION void apply_contact(const LawParameters* law, const Particle* particle, const Contact* contact,
                                   ContactHistory* history, ForceSum* sum) {
  const real4 parameters = parameters_of(law, particle, contact);
  const real3 n = contact->contact_normal;
  const real area = contact->overlap * contact->radius;
  const real inverse_root = reciprocal_square_root(fmax(area * radius_ratio_of(law, contact), SMALL_REAL));
  const real contact_radius = area * inverse_root;                  // sqrt(overlap R*)
  const real normal_stiffness = parameters.x * contact_radius;      // eq. (8)
  const real tangential_stiffness = parameters.y * contact_radius;  // eq. (9)
  const real damped = normal_stiffness * contact->mass;
  const real damping_coefficient =
      parameters.z * damped *
      inverse_root_by_multiplication(damped * mass_ratio_of(law, contact));  // eq. (10)

  const ContactMotion motion = contact_motion(particle, contact);
  real3 tangential_displacement =
      continued_displacement(remembered_displacement(history, contact->partner), n, &motion, law->time_step);

  real normal_force =
      normal_force_of(normal_stiffness, contact->overlap, damping_coefficient, &motion);  // eq. (4)
#if NORMAL_FORCE == NORMAL_FORCE_REPULSIVE
  normal_force = fmax(normal_force, REAL(0.0));
#endif

  const real friction_limit = parameters.w * fabs(normal_force);
  const real3 spring_force = tangential_spring_force(tangential_stiffness, tangential_displacement);
  const real3 damping_force = tangential_damping_force(damping_coefficient, &motion);
  real3 tangential_force = spring_force + damping_force;  // eq. (4)
  const real3 tested_force = tested_by_friction(spring_force, tangential_force);
  const real tested_square = dot(tested_force, tested_force);
  if (tested_square > friction_limit * friction_limit) {  // branch: slip
    tangential_force = tested_force * (friction_limit * reciprocal_square_root(tested_square));  // eq. (5)
#if SLIP_HISTORY != SLIP_HISTORY_PAPER
    if (tangential_stiffness > REAL(0.0)) {  // branch: tangential spring
      tangential_displacement = -held_by_spring(tangential_force, damping_force) *
                                quotient(inverse_root * radius_ratio_of(law, contact), parameters.y);
    }
#endif
  }
  remember_displacement(history, contact->partner, tangential_displacement);
  add_contact(sum, particle, n, normal_force, tangential_force);
}
