// The overlap of two spheres, as exact as their positions and radii are.
//
// Overlap = reach - distance: in a settled bed the two lengths agree to 4 or 5 digits, so that the rounding
// of the distance, one part in 10^7, is thousandths of what is left. In float the distance is therefore
// corrected by one Newton step of the square root, whose residual distance^2 - |separation|^2 is summed
// without rounding errors: fma() gives the error of each product, Fast2Sum (Dekker 1971,
// doi:10.1007/BF01397083) that of each difference. In double the plain difference is as good as positions
// are.
#ifndef WARPGRAIN_OVERLAP_H
#define WARPGRAIN_OVERLAP_H

#include "prelude.h"

// How a particle touches another sphere or a wall.
typedef struct {
  real3 contact_normal;  // unit, from the particle to the other
  real overlap;          // never negative
} Touch;

typedef struct {
  real value;    // rounded
  real inverse;  // 1 / value
} Distance;

DEVICE_FUNCTION Distance distance_of(real square) {
  Distance distance;
#ifdef ONE_ROOT_A_PAIR
  // The value is twice as far off as a root; the overlap's Newton step takes that out again.
  distance.inverse = reciprocal_square_root(square);
  distance.value = square * distance.inverse;
#else
  distance.value = square_root(square);
  distance.inverse = quotient(REAL(1.0), distance.value);
#endif
  return distance;
}

#if REAL_BITS == 32
// (high, low) -= x * x
DEVICE_FUNCTION void subtract_square(real x, real* high, real* low) {
  FP_CONTRACT_OFF
  const real square = rounded_product(x, x);
  const real rest_of_square = fma(x, x, -square);
  const real difference = *high - square;
  *low += ((*high - difference) - square) - rest_of_square;
  *high = difference;
}
#endif

// `distance` is the length of `separation`, less than `reach`. Never negative.
DEVICE_FUNCTION real overlap_of_spheres(real3 separation, Distance distance, real reach) {
#if REAL_BITS == 32
  FP_CONTRACT_OFF
  real high = rounded_product(distance.value, distance.value);
  real low = fma(distance.value, distance.value, -high);
  subtract_square(separation.x, &high, &low);
  subtract_square(separation.y, &high, &low);
  subtract_square(separation.z, &high, &low);
  return fmax((reach - distance.value) + REAL(0.5) * distance.inverse * (high + low), REAL(0.0));
#else
  return reach - distance.value;
#endif
}

#endif
