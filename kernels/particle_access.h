// Loading and storing the particle of a work-item, for the kernels that evaluate forces.
#ifndef WARPGRAIN_PARTICLE_ACCESS_H
#define WARPGRAIN_PARTICLE_ACCESS_H

#include "contact/contact_law.h"
#include "prelude.h"
#include "status.h"

// What forces depend on, and what they are added up in: parameters of the kernels, and how those are gathered
// into Particles and Sums.
#if READS_MOTION
#define MOTION_PARAMETER , GLOBAL const real4* velocity_mass
#define MOTION_ARGUMENT , velocity_mass
#else
#define MOTION_PARAMETER
#define MOTION_ARGUMENT
#endif
#if HAS_ROTATION
#define ROTATION_PARAMETER , GLOBAL const real4* angular_velocity
#define ROTATION_ARGUMENT , angular_velocity
#define TORQUE_PARAMETER , GLOBAL real4* torque
#define TORQUE_ARGUMENT , torque
#else
#define ROTATION_PARAMETER
#define ROTATION_ARGUMENT
#define TORQUE_PARAMETER
#define TORQUE_ARGUMENT
#endif
#define PARTICLE_PARAMETERS                                                \
  GLOBAL const Place *position_radius MOTION_PARAMETER ROTATION_PARAMETER, \
      GLOBAL const Identity *rank_material
#define PARTICLES \
  { position_radius MOTION_ARGUMENT ROTATION_ARGUMENT, rank_material }
#define SUM_PARAMETERS GLOBAL real4* force TORQUE_PARAMETER
#define SUMS \
  { force TORQUE_ARGUMENT }

// Numbers of a ForceSum.
#define SUM_REALS (HAS_ROTATION ? 6 : 3)

typedef struct {
  GLOBAL const Place* position_radius;
#if READS_MOTION
  GLOBAL const real4* velocity_mass;
#endif
#if HAS_ROTATION
  GLOBAL const real4* angular_velocity;
#endif
  GLOBAL const Identity* rank_material;
} Particles;

typedef struct {
  GLOBAL real4* force;
#if HAS_ROTATION
  GLOBAL real4* torque;
#endif
} Sums;

// Of a velocity_mass that is not there, nobody asks.
DEVICE_FUNCTION real4 motion_of(const Particles* particles, uint index) {
#if READS_MOTION
  return particles->velocity_mass[index];
#else
  (void)particles, (void)index;
  return make_real4(NO_FORCE, REAL(0.0));
#endif
}

// What a search has to know.
DEVICE_FUNCTION void load_place(const StepParameters p, Place place, Identity identity, Particle* particle) {
#if !HAS_RADII
  place.w = p.radius;
#endif
  particle->place = place;
  particle->radius = radius_of(place);
  particle->rank = rank_in(identity);
}

DEVICE_FUNCTION Particle load_particle(const StepParameters p, uint index, const Particles* particles) {
  const real4 motion = motion_of(particles, index);
  const Identity identity = particles->rank_material[index];
  Particle particle;
  load_place(p, particles->position_radius[index], identity, &particle);
  particle.velocity = xyz(motion);
#if HAS_MASSES
  particle.mass = motion.w;
#else
  particle.mass = p.mass;
#endif
#if HAS_ROTATION
  particle.angular_velocity = xyz(particles->angular_velocity[index]);
#endif
  particle.inverse_radius = quotient(REAL(1.0), particle.radius);
  particle.inverse_mass = quotient(REAL(1.0), particle.mass);
  particle.material = material_in(identity);
  return particle;
}

// What a sum of the forces of contacts begins with.
DEVICE_FUNCTION ForceSum no_sum(void) {
  ForceSum sum;
  sum.force = make_real3(REAL(0.0), REAL(0.0), REAL(0.0));
#if HAS_ROTATION
  sum.torque = sum.force;
#endif
  return sum;
}

DEVICE_FUNCTION void add_to_sum(ForceSum* sum, const ForceSum* added) {
  sum->force += added->force;
#if HAS_ROTATION
  sum->torque += added->torque;
#endif
}

// What the sum of all forces on a particle begins with.
DEVICE_FUNCTION ForceSum gravity_alone(const StepParameters p, real mass) {
  ForceSum sum = no_sum();
#if HAS_GRAVITY
  sum.force = vector_of(p.gravity) * mass;
#else
  (void)p, (void)mass;
#endif
  return sum;
}

// Nothing that is not a number goes further unnoticed.
DEVICE_FUNCTION void check_sum(const ForceSum* sum, uint rank, GLOBAL uint* status) {
  real3 check = sum->force;
#if HAS_ROTATION
  check += sum->torque;
#endif
  if (!is_finite(check.x + check.y + check.z)) report_error(status, STATUS_NOT_FINITE, rank);
}

DEVICE_FUNCTION ForceSum load_forces(uint index, const Sums* sums) {
  ForceSum sum;
  sum.force = xyz(sums->force[index]);
#if HAS_ROTATION
  sum.torque = xyz(sums->torque[index]);
#endif
  return sum;
}
DEVICE_FUNCTION void store_forces(uint index, const ForceSum* sum, const Sums* sums) {
  sums->force[index] = make_real4(sum->force, REAL(0.0));
#if HAS_ROTATION
  sums->torque[index] = make_real4(sum->torque, REAL(0.0));
#endif
}

// What the kernels that follow begin with: the walls go on from it.
DEVICE_FUNCTION void store_sum(uint index, const Particles* particles, const ForceSum* sum, uint n_contacts,
                               const Sums* sums, GLOBAL uint2* contact_counts, GLOBAL uint* status) {
#if HAS_WALLS
  (void)particles, (void)status;
#else
  check_sum(sum, rank_in(particles->rank_material[index]), status);
#endif
  store_forces(index, sum, sums);
  contact_counts[index] = make_uint2(n_contacts, 0);
}

#endif
