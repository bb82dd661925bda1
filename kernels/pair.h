// The contact of two particles, for the kernels that search partners.
#ifndef WARPGRAIN_PAIR_H
#define WARPGRAIN_PAIR_H

#include "contact/contact_law.h"
#include "overlap.h"
#include "prelude.h"

// From a particle to another one, and how near they are.
typedef struct {
  real3 separation;
  real square;  // of the distance
  real radius;  // of the other
  real reach;   // the sum of the radii
} Pair;

DEVICE_FUNCTION Pair pair_with(const Particle* particle, real4 place_of_other) {
  Pair pair;
  pair.separation = xyz(place_of_other) - particle->position;
  pair.square = dot(pair.separation, pair.separation);
  pair.radius = place_of_other.w;
  pair.reach = particle->radius + place_of_other.w;
  return pair;
}

// Of a pair that touches, which is when its square is below that of its reach; `other` is the partner's place
// in the arrays.
DEVICE_FUNCTION Contact contact_of(const Particle* particle, const Pair* pair, uint other,
                                   GLOBAL const real4* velocity_mass, GLOBAL const real4* angular_velocity,
                                   GLOBAL const uint2* rank_material) {
  const real4 motion = velocity_mass[other];
  const uint2 identity = rank_material[other];
  const Distance distance = distance_of(pair->square);
  Contact contact;
  contact.contact_normal = pair->separation * distance.inverse;
  contact.overlap = overlap_of_spheres(pair->separation, distance, pair->reach);
  contact.velocity = xyz(motion);
  contact.surface_rotation = pair->radius * xyz(angular_velocity[other]);
  contact.inverse_radius = quotient(REAL(1.0), pair->radius);
  contact.inverse_mass = quotient(REAL(1.0), motion.w);
  contact.radius = pair->radius;
  contact.radius_ratio = pair->reach * particle->inverse_radius;
  contact.mass = motion.w;
  contact.mass_ratio = (particle->mass + motion.w) * particle->inverse_mass;
  contact.partner = identity.x;
  contact.material = identity.y;
  return contact;
}

#endif
