// Loading and storing the particle of a work-item, for the kernels that evaluate forces.
#ifndef WARPGRAIN_PARTICLE_ACCESS_H
#define WARPGRAIN_PARTICLE_ACCESS_H

#include "contact/contact_law.h"
#include "prelude.h"

DEVICE_FUNCTION Particle load_particle(uint index, GLOBAL const Place* position_radius,
                                       GLOBAL const real4* velocity_mass,
                                       GLOBAL const real4* angular_velocity,
                                       GLOBAL const uint2* rank_material) {
  Particle particle;
  particle.place = position_radius[index];
  particle.radius = radius_of(particle.place);
  particle.velocity = xyz(velocity_mass[index]);
  particle.mass = velocity_mass[index].w;
  particle.angular_velocity = xyz(angular_velocity[index]);
  particle.inverse_radius = quotient(REAL(1.0), particle.radius);
  particle.inverse_mass = quotient(REAL(1.0), particle.mass);
  particle.rank = rank_material[index].x;
  particle.material = rank_material[index].y;
  return particle;
}

// What a sum of forces begins with.
DEVICE_FUNCTION ForceSum gravity_alone(const StepParameters p, const Particle* particle) {
  ForceSum sum;
  sum.force = vector_of(p.gravity) * particle->mass;
  sum.torque = make_real3(REAL(0.0), REAL(0.0), REAL(0.0));
  return sum;
}

// What the kernels that follow begin with: the walls go on from it.
DEVICE_FUNCTION void store_sum(uint index, const ForceSum* sum, uint n_contacts, GLOBAL real4* force,
                               GLOBAL real4* torque, GLOBAL uint2* contact_counts) {
  force[index] = make_real4(sum->force, REAL(0.0));
  torque[index] = make_real4(sum->torque, REAL(0.0));
  contact_counts[index] = make_uint2(n_contacts, 0);
}

#endif
