// Where a particle touches a wall.
#ifndef WARPGRAIN_WALL_H
#define WARPGRAIN_WALL_H

#include "overlap.h"
#include "pair.h"
#include "place.h"
#include "prelude.h"

#ifdef FIXED_POINT
#include "wall_fixed.h"
#else
typedef WallLayout Wall;

// From the particle to the nearest point of the wall.
DEVICE_FUNCTION real3 separation_from_rectangle(CONSTANT const Wall* wall, real3 position) {
  const real3 offset = position - vector_of(wall->point);
  const real u = clamp(dot(offset, vector_of(wall->fraction_u)), REAL(0.0), REAL(1.0));
  const real v = clamp(dot(offset, vector_of(wall->fraction_v)), REAL(0.0), REAL(1.0));
  const real3 nearest = u * vector_of(wall->edge_u) + v * vector_of(wall->edge_v);
  return nearest - offset;
}

DEVICE_FUNCTION bool touch_rectangle(CONSTANT const Wall* wall, Place place, Touch* touch) {
  const real3 separation = separation_from_rectangle(wall, xyz(place));
  const real square = dot(separation, separation);
  if (square >= place.w * place.w) return false;
  const real distance = square_root(square);
  touch->contact_normal =
      distance > REAL(0.0) ? quotient_of_vector(separation, distance) : -vector_of(wall->normal);
  touch->overlap = place.w - distance;
  return true;
}

DEVICE_FUNCTION bool touch_plane(CONSTANT const Wall* wall, Place place, Touch* touch) {
  // Near a wall both differences are exact, so that the rest of its place is added to what they leave.
  const real3 normal = vector_of(wall->normal);
  const real distance = dot(xyz(place) - vector_of(wall->point), normal);
  touch->contact_normal = -normal;
  touch->overlap = (place.w - distance) + wall->point_rest;
  return !(touch->overlap <= REAL(0.0));  // a NaN goes on, to be noticed
}
#endif

// Known where a scene has walls of one kind.
#if HAS_PLANES && HAS_RECTANGLES
#define is_rectangle(wall) ((wall)->is_rectangle)
#else
#define is_rectangle(wall) HAS_RECTANGLES
#endif

#endif
