// What the laws of the practical model share: the motion at a contact and the sums over contacts. How a law
// comes from them to its forces is what the laws differ in.
#ifndef WARPGRAIN_CONTACT_PRACTICAL_H
#define WARPGRAIN_CONTACT_PRACTICAL_H

#include "contact/contact_law.h"

#ifndef SLIP_HISTORY
#define SLIP_HISTORY SLIP_HISTORY_CLIP
#endif
#ifndef NORMAL_FORCE
#define NORMAL_FORCE NORMAL_FORCE_SIGNED
#endif

typedef struct {
  real normal_velocity;
  real3 tangential_velocity;
} ContactMotion;

// eq. (6)
DEVICE_FUNCTION ContactMotion contact_motion(const Particle* particle, const Contact* contact) {
  const real3 n = contact->contact_normal;
  const real3 relative_velocity = particle->velocity - contact->velocity;
#if HAS_ROTATION
  const real3 surface_rotation = particle->radius * particle->angular_velocity + contact->surface_rotation;
#else
  const real3 surface_rotation = contact->surface_rotation;
#endif
  ContactMotion motion;
  motion.normal_velocity = dot(relative_velocity, n);
  motion.tangential_velocity = relative_velocity - motion.normal_velocity * n + cross(surface_rotation, n);
  return motion;
}

// eq. (7): the old displacement in the contact plane of now, and what has been added to it in the step.
DEVICE_FUNCTION real3 continued_displacement(real3 old_displacement, real3 n, const ContactMotion* motion,
                                             real time_step) {
  return old_displacement - dot(old_displacement, n) * n + motion->tangential_velocity * time_step;
}

// The parts of eq. (4). The normal force is along -n: positive pushes the particle away from its partner.
DEVICE_FUNCTION real normal_force_of(real stiffness, real overlap, real damping_coefficient,
                                     const ContactMotion* motion) {
#if HAS_DAMPING
  return stiffness * overlap + damping_coefficient * motion->normal_velocity;
#else
  (void)damping_coefficient, (void)motion;
  return stiffness * overlap;
#endif
}
DEVICE_FUNCTION real3 tangential_spring_force(real stiffness, real3 displacement) {
#if CONTACT_SLOTS > 0
  return -stiffness * displacement;
#else
  (void)stiffness, (void)displacement;
  return NO_FORCE;
#endif
}
DEVICE_FUNCTION real3 tangential_damping_force(real damping_coefficient, const ContactMotion* motion) {
#if HAS_DAMPING
  return -damping_coefficient * motion->tangential_velocity;
#else
  (void)damping_coefficient, (void)motion;
  return NO_FORCE;
#endif
}

// What eq. (5) compares with its limit: the whole tangential force, or the spring's part of it.
DEVICE_FUNCTION real3 tested_by_friction(real3 spring_force, real3 tangential_force) {
#if SLIP_HISTORY == SLIP_HISTORY_LIGGGHTS
  return spring_force;
#else
  return tangential_force;
#endif
}

// Of the force that friction has cut, what the spring holds from then on.
DEVICE_FUNCTION real3 held_by_spring(real3 cut_force, real3 damping_force) {
#if SLIP_HISTORY == SLIP_HISTORY_LAMMPS
  return cut_force - damping_force;
#else
  return cut_force;
#endif
}

// eqs. (2) and (3). Without friction the product is rounded before it is added, as where the tangential force
// is zero, so that both give the same bits.
DEVICE_FUNCTION void add_contact(ForceSum* sum, const Particle* particle, real3 n, real normal_force,
                                 real3 tangential_force) {
#if HAS_FRICTION
  sum->force += tangential_force - normal_force * n;
  sum->torque += particle->radius * cross(n, tangential_force);
#else
  (void)particle, (void)tangential_force;
  const real3 push = normal_force * n;
  sum->force -= push;
#endif
}

#endif
