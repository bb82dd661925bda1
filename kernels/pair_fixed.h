// Two spheres in fixed point: whether they touch, and their overlap, as exact wherever they are.
//
// Lengths between spheres that may touch are cut in two: a coarse part, an integer in 2^SEPARATION_SHIFT
// units, and a rest of at most half of one. Coarse parts are below 2^30 for particles in cells beside each
// other, so that their squares add up exactly in 64 bits. From R^2 - d^2, exact in its coarse part,
//   overlap = R - d = (R^2 - d^2) / (R + d),
// with everything but R^2 - d^2 in float.
#ifndef WARPGRAIN_PAIR_FIXED_H
#define WARPGRAIN_PAIR_FIXED_H

#include "place.h"

#define COARSE_UNITS (1l << SEPARATION_SHIFT)
#define COARSE_LENGTH (POSITION_UNIT * (real)COARSE_UNITS)

// From a particle to another sphere.
typedef struct {
  long x, y, z, reach_units;  // the way, and the sum of the radii
  real radius;                // of the other [m]
  real reach;                 // the sum of the radii [m]
} Pair;

DEVICE_FUNCTION Pair pair_with(Place place, Place other) {
#if !HAS_RADII
  other.w = place.w;
#endif
  Pair pair;
  pair.x = other.x - place.x;
  pair.y = other.y - place.y;
  pair.z = other.z - place.z;
  pair.reach_units = place.w + other.w;
  pair.radius = radius_of(other);
  pair.reach = length_of(pair.reach_units);
  return pair;
}

// -D FAR_PAIRS: the search looks at pairs that are not near each other; the farthest it needs to know is far.
DEVICE_FUNCTION int coarse_part(long units) {
#ifdef FAR_PAIRS
  units = clamp(units, -(COARSE_UNITS << 29), COARSE_UNITS << 29);
#endif
  return (int)((units + COARSE_UNITS / 2) >> SEPARATION_SHIFT);
}
// In coarse units.
DEVICE_FUNCTION real rest_of(long units) {
  return (real)(int)(units - ((long)coarse_part(units) << SEPARATION_SHIFT)) *
         (REAL(1.0) / (real)COARSE_UNITS);
}
DEVICE_FUNCTION long coarse_square(const Pair* pair) {
  const long x = coarse_part(pair->x), y = coarse_part(pair->y), z = coarse_part(pair->z);
  return x * x + y * y + z * z;
}

// Never false for spheres nearer than that; true for some that are up to two coarse units farther apart,
// whose overlap is zero.
DEVICE_FUNCTION long limit_square(const Pair* pair, real gap) {
  const long limit = coarse_part(pair->reach_units) + (int)(gap * (REAL(1.0) / COARSE_LENGTH)) + 3;
  return limit * limit;
}
#define is_within(pair, gap) (coarse_square(pair) < limit_square(pair, gap))
#define touches(pair) is_within(pair, REAL(0.0))

DEVICE_FUNCTION Touch touch_of(const Pair* pair) {
  const long reach = coarse_part(pair->reach_units);
  const real3 coarse =
      make_real3((real)coarse_part(pair->x), (real)coarse_part(pair->y), (real)coarse_part(pair->z));
  const real3 rest = make_real3(rest_of(pair->x), rest_of(pair->y), rest_of(pair->z));
  const real rest_of_reach = rest_of(pair->reach_units);
  const real of_rests = REAL(2.0) * ((real)reach * rest_of_reach - dot(coarse, rest)) +
                        (rest_of_reach * rest_of_reach - dot(rest, rest));
  const real difference_of_squares = (real)(reach * reach - coarse_square(pair)) + of_rests;
  const real3 separation = coarse + rest;
  const Distance distance = distance_of(dot(separation, separation));
  Touch touch;
  touch.contact_normal = separation * distance.inverse;
  touch.overlap =
      fmax(quotient(difference_of_squares, (real)reach + distance.value), REAL(0.0)) * COARSE_LENGTH;
  return touch;
}

#endif
