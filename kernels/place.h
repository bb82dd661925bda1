// A particle's place: its centre and its radius, in one of two kinds with the same functions.
//
// Floating: real4, in metres. Fixed (-D FIXED_POINT, precision `mixed`): long4, in units of POSITION_UNIT, a
// power of two [m], so that differences of places are exact. All of a scene are within 2^61 units.
// variants/fixed_point.hpp chooses the unit.
#ifndef WARPGRAIN_PLACE_H
#define WARPGRAIN_PLACE_H

#include "prelude.h"

#ifdef FIXED_POINT
#ifndef POSITION_UNIT
#define POSITION_UNIT 0x1p-50f
#define SEPARATION_SHIFT 16
#endif

DEVICE_FUNCTION real length_of(long units) { return (real)units * POSITION_UNIT; }
DEVICE_FUNCTION real length_between(long from, long to) { return length_of(to - from); }
DEVICE_FUNCTION real radius_of(Place place) { return length_of(place.w); }
DEVICE_FUNCTION real3 way_between(Place from, Place to) {
  return make_real3(length_between(from.x, to.x), length_between(from.y, to.y), length_between(from.z, to.z));
}

// What a step that is not a number leads to is LONG_MIN; steps out of the domain end within 2^62.
DEVICE_FUNCTION long moved_along(long from, real velocity, real time_step) {
  const real step = velocity * time_step * (REAL(1.0) / POSITION_UNIT);
  const real bound = REAL(0x1p61);
  const long to = from + rounded_to_long(clamp(step, -bound, bound));
  return is_finite(step) ? clamp(to, -(1l << 62), 1l << 62) : LONG_MIN;
}
DEVICE_FUNCTION Place moved_place(Place place, real3 velocity, real time_step) {
  return make_place(moved_along(place.x, velocity.x, time_step), moved_along(place.y, velocity.y, time_step),
                    moved_along(place.z, velocity.z, time_step), place.w);
}
DEVICE_FUNCTION bool is_a_place(Place place) {
  return place.x != LONG_MIN && place.y != LONG_MIN && place.z != LONG_MIN;
}
#else
DEVICE_FUNCTION real length_between(real from, real to) { return to - from; }
DEVICE_FUNCTION real radius_of(Place place) { return place.w; }
DEVICE_FUNCTION real3 way_between(Place from, Place to) { return xyz(to) - xyz(from); }
DEVICE_FUNCTION Place moved_place(Place place, real3 velocity, real time_step) {
  return make_real4(xyz(place) + velocity * time_step, place.w);
}
DEVICE_FUNCTION bool is_a_place(Place place) { return is_finite(place.x + place.y + place.z); }
#endif

#endif
