#include "core/wall.hpp"

#include <algorithm>

namespace warpgrain {

WallProximity wall_proximity(const Wall& wall, const Vector3d& centre) {
  const Vector3d from_point = centre - wall.point;
  if (wall.kind == WallKind::plane) return {from_point.dot(wall.normal), -wall.normal};

  const Vector3d &u = wall.edge_u, &v = wall.edge_v;
  const double along_u = std::clamp(from_point.dot(u) / u.squaredNorm(), 0.0, 1.0);
  const double along_v = std::clamp(from_point.dot(v) / v.squaredNorm(), 0.0, 1.0);
  const Vector3d to_nearest = u * along_u + v * along_v - from_point;
  const double distance = to_nearest.norm();
  return {distance, distance > 0 ? Vector3d(to_nearest / distance) : Vector3d(-wall.normal)};
}

}  // namespace warpgrain
