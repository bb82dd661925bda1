#pragma once
// Walls: particles of infinite radius and infinite mass at rest (1/r_j = 0, 1/m_j = 0, r_j w_j = 0).
// Each wall is a contact partner of its own (wall_partner_bit | index), also where two rectangles meet: a
// sphere on the joint of two coplanar rectangles touches both and feels both. Lay flat ground as one wall.

#include <cstdint>

#include "core/vector3.hpp"

namespace warpgrain {

enum class WallKind : std::uint8_t {
  plane,     // infinite; particles live on the side that `normal` points to
  rectangle  // finite and two-sided, touched at its nearest point, so edges and corners work
};

struct Wall {
  WallKind kind = WallKind::plane;
  std::uint32_t material = 0;           // index into Scene::materials
  Vector3d point = Vector3d::Zero();    // a point of the plane, or the rectangle's corner
  Vector3d normal = Vector3d::UnitZ();  // unit; of a rectangle: edge_u x edge_v, normalised
  Vector3d edge_u = Vector3d::Zero(), edge_v = Vector3d::Zero();  // rectangle only: perpendicular edges [m]
};

// Where a sphere's centre stands to a wall. In double for a solver in float too: float places of a wall at
// 0.1 m lie 7 nm apart, and a settled bed's overlaps are not much larger.
struct WallProximity {
  double distance = 0;  // m, from the centre to the wall; of a plane it is signed: negative behind it
  // Unit vector from the centre to the nearest point. Of a plane always -normal, so that a centre behind it
  // is still pushed to the living side; a centre exactly on a rectangle is given -normal too.
  Vector3d contact_normal = Vector3d::Zero();
};

// The nearest point of a plane or rectangle is the orthogonal projection, in a rectangle clamped to its
// edges.
WallProximity wall_proximity(const Wall& wall, const Vector3d& centre);

}  // namespace warpgrain
