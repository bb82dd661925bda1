#include "core/scene_domain.hpp"

#include <algorithm>
#include <limits>

namespace warpgrain {
namespace {

// Calls visit(axis, direction, coordinate) for every plane perpendicular to an axis; particles live where the
// coordinate along the axis, times direction (+1 or -1), is larger.
template <class Visit>
void for_each_axis_plane(const Scene& scene, Visit&& visit) {
  for (const Wall& wall : scene.walls)
    for (int axis = 0; axis < 3; ++axis)
      if (wall.kind == WallKind::plane && std::abs(wall.normal[axis]) > 1 - 1e-12)
        visit(axis, wall.normal[axis] > 0 ? 1 : -1, wall.point[axis]);
}

double largest_radius(const Scene& scene) {
  return *std::max_element(scene.particles.radius.begin(), scene.particles.radius.end());
}

double room_for_travel(const Scene& scene, const Box& box) {
  if (scene.end.at_rest) return (box.upper - box.lower).maxCoeff();
  const double time =
      scene.end.time ? *scene.end.time : static_cast<double>(*scene.end.steps) * scene.time_step;
  double speed = 0;
  for (const Vector3d& velocity : scene.particles.velocity) speed = std::max(speed, velocity.norm());
  return 2 * (speed * time + scene.gravity.norm() * time * time / 2);
}

Box widened(const Scene& scene, Box box, double margin) {
  box.lower.array() -= margin;
  box.upper.array() += margin;
  for_each_axis_plane(scene, [&](int axis, int direction, double coordinate) {
    if (direction > 0)
      box.lower[axis] = std::max(box.lower[axis], coordinate);
    else
      box.upper[axis] = std::min(box.upper[axis], coordinate);
  });
  return box;
}

}  // namespace

Box box_around(const Scene& scene) {
  Box box{Vector3d::Constant(std::numeric_limits<double>::infinity()),
          Vector3d::Constant(-std::numeric_limits<double>::infinity())};
  const auto include = [&](const Vector3d& point, double radius) {
    box.lower = box.lower.cwiseMin((point.array() - radius).matrix());
    box.upper = box.upper.cwiseMax((point.array() + radius).matrix());
  };
  for (std::size_t k = 0; k < scene.particles.size(); ++k)
    include(scene.particles.position[k], scene.particles.radius[k]);
  for (const Wall& wall : scene.walls)
    if (wall.kind == WallKind::rectangle)
      for (double u : {0.0, 1.0})
        for (double v : {0.0, 1.0}) include(wall.point + u * wall.edge_u + v * wall.edge_v, 0);
  for_each_axis_plane(scene, [&](int axis, int, double coordinate) {
    box.lower[axis] = std::min(box.lower[axis], coordinate);
    box.upper[axis] = std::max(box.upper[axis], coordinate);
  });
  return box;
}

Box derive_domain(const Scene& scene) {
  const Box box = box_around(scene);
  const double radius = largest_radius(scene);
  const auto cells = [&](const Box& domain) {
    return ((domain.upper - domain.lower) / (2 * radius)).array().ceil().prod();
  };
  double travel = room_for_travel(scene, box);
  Box domain = widened(scene, box, 4 * radius + travel);
  while (cells(domain) > (1u << 21) && travel > radius) {
    travel /= 2;
    domain = widened(scene, box, 4 * radius + travel);
  }
  return domain;
}

}  // namespace warpgrain
