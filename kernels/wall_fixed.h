// Walls in fixed point: how far a place is along each axis of a wall comes from whole products, so that it is
// as exact as differences of places are, whichever way the wall leans.
#ifndef WARPGRAIN_WALL_FIXED_H
#define WARPGRAIN_WALL_FIXED_H

#include "pair_fixed.h"
#include "place.h"

typedef FixedWallLayout Wall;

// The high half of a product with an axis, which is in 2^-62, is in 2^-2 of the product's units.
DEVICE_FUNCTION long along_axis(CONSTANT const Wall* wall, int axis, Place place) {
  return 4 * (high_product(place.x - wall->point[0], wall->axes[axis][0]) +
              high_product(place.y - wall->point[1], wall->axes[axis][1]) +
              high_product(place.z - wall->point[2], wall->axes[axis][2]));
}

// How far beyond either end of an edge; zero beside it.
DEVICE_FUNCTION long beyond_edge(long along, long length) { return along - clamp(along, 0l, length); }

DEVICE_FUNCTION bool touch_rectangle(CONSTANT const Wall* wall, Place place, Touch* touch) {
  const long away = along_axis(wall, 0, place);
  Pair nearest;  // the way there along normal and edges
  nearest.x = away != 0 ? -away : -1;
  nearest.y = -beyond_edge(along_axis(wall, 1, place), wall->length_u);
  nearest.z = -beyond_edge(along_axis(wall, 2, place), wall->length_v);
  nearest.reach_units = place.w;
  const bool is_near = nearest.x < place.w && nearest.x > -place.w && nearest.y < place.w &&
                       nearest.y > -place.w && nearest.z < place.w && nearest.z > -place.w;
  if (!is_near || !touches(&nearest)) return false;
  *touch = touch_of(&nearest);
  const real3 n = touch->contact_normal;
  touch->contact_normal =
      n.x * vector_of(wall->normal) + n.y * vector_of(wall->along_u) + n.z * vector_of(wall->along_v);
  return true;
}

DEVICE_FUNCTION bool touch_plane(CONSTANT const Wall* wall, Place place, Touch* touch) {
  const long overlap = place.w - along_axis(wall, 0, place);
  touch->contact_normal = -vector_of(wall->normal);
  touch->overlap = length_of(overlap);
  return overlap > 0;
}

#endif
