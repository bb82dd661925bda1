// The contact of two particles, for the kernels that search partners.
#ifndef WARPGRAIN_PAIR_H
#define WARPGRAIN_PAIR_H

#include "contact/contact_law.h"
#include "overlap.h"
#include "particle_access.h"
#include "prelude.h"

#ifdef FIXED_POINT
#include "pair_fixed.h"
#else
// From a particle to another one, and how near they are.
typedef struct {
  real3 separation;
  real square;  // of the distance
  real radius;  // of the other
  real reach;   // the sum of the radii
} Pair;

DEVICE_FUNCTION Pair pair_with(Place place, Place other) {
#if !HAS_RADII
  other.w = place.w;
#endif
  Pair pair;
  pair.separation = way_between(place, other);
  pair.square = dot(pair.separation, pair.separation);
  pair.radius = radius_of(other);
  pair.reach = radius_of(place) + pair.radius;
  return pair;
}

// Whether the surfaces are nearer than `gap`. Comparisons are macros, so that a branch on one has the line of
// its user.
DEVICE_FUNCTION real limit_square(const Pair* pair, real gap) {
  const real limit = pair->reach + gap;
  return limit * limit;
}
#define is_within(pair, gap) ((pair)->square < limit_square(pair, gap))
#define touches(pair) ((pair)->square < (pair)->reach * (pair)->reach)

DEVICE_FUNCTION Touch touch_of(const Pair* pair) {
  const Distance distance = distance_of(pair->square);
  Touch touch;
  touch.contact_normal = pair->separation * distance.inverse;
  touch.overlap = overlap_of_spheres(pair->separation, distance, pair->reach);
  return touch;
}
#endif

// Of a pair that touches; `other` is the partner's index in the arrays.
DEVICE_FUNCTION Contact contact_of(const Particle* particle, const Pair* pair, uint other,
                                   const Particles* particles) {
  const real4 motion = motion_of(particles, other);
  const Identity identity = particles->rank_material[other];
  const Touch touch = touch_of(pair);
  Contact contact;
  contact.contact_normal = touch.contact_normal;
  contact.overlap = touch.overlap;
  contact.velocity = xyz(motion);
#if HAS_ROTATION
  contact.surface_rotation = pair->radius * xyz(particles->angular_velocity[other]);
#else
  contact.surface_rotation = NO_FORCE;
#endif
  contact.inverse_radius = quotient(REAL(1.0), pair->radius);
#if HAS_MASSES
  contact.mass = motion.w;
#else
  contact.mass = particle->mass;
#endif
  contact.inverse_mass = quotient(REAL(1.0), contact.mass);
  contact.radius = pair->radius;
  contact.radius_ratio = pair->reach * particle->inverse_radius;
  contact.mass_ratio = (particle->mass + contact.mass) * particle->inverse_mass;
  contact.partner = rank_in(identity);
  contact.material = material_in(identity);
  return contact;
}

#endif
