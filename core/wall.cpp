#include "core/wall.hpp"

#include <algorithm>

namespace warpgrain {

template <class Real>
WallProximity<Real> wall_proximity(const Wall& wall, const Vector3<Real>& centre) {
  const Vector3<Real> normal = wall.normal.cast<Real>();
  const Vector3<Real> from_point = centre - wall.point.cast<Real>();
  if (wall.kind == WallKind::plane) return {from_point.dot(normal), -normal};

  const Vector3<Real> u = wall.edge_u.cast<Real>(), v = wall.edge_v.cast<Real>();
  const Real along_u = std::clamp(from_point.dot(u) / u.squaredNorm(), Real(0), Real(1));
  const Real along_v = std::clamp(from_point.dot(v) / v.squaredNorm(), Real(0), Real(1));
  const Vector3<Real> to_nearest = u * along_u + v * along_v - from_point;
  const Real distance = to_nearest.norm();
  return {distance, distance > 0 ? Vector3<Real>(to_nearest / distance) : Vector3<Real>(-normal)};
}

template WallProximity<float> wall_proximity(const Wall&, const Vector3<float>&);
template WallProximity<double> wall_proximity(const Wall&, const Vector3<double>&);

}  // namespace warpgrain
