#pragma once
// Walls: particles of infinite radius and infinite mass at rest (1/r_j = 0, 1/m_j = 0, r_j w_j = 0).

#include <cstdint>

#include "core/vector3.hpp"

namespace warpgrain {

enum class WallKind : std::uint8_t {
  plane,     // infinite; particles live on the side that `normal` points to
  rectangle  // finite and two-sided, touched at its nearest point, so edges and corners work
};

struct Wall {
  WallKind kind = WallKind::plane;
  std::uint32_t material = 0;  // index into Scene::materials
  Vector3d point = Vector3d::Zero();                                // a point of the plane, or the rectangle's corner
  Vector3d normal = Vector3d::UnitZ();                              // unit; of a rectangle: edge_u x edge_v, normalised
  Vector3d edge_u = Vector3d::Zero(), edge_v = Vector3d::Zero();    // rectangle only: perpendicular edges [m]
};

}  // namespace warpgrain
