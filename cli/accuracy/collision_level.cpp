#include "cli/accuracy/collision_level.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/time_step.hpp"

namespace warpgrain::cli {
namespace {

constexpr std::array angles{0.0, 15.0, 45.0, 75.0};

double impact_speed(const Scene& scene) {
  const double speed = time_step_limits(scene).impact_speed;
  return speed > 0 ? speed : 1;
}

// The smallest grain meets one like it; pairs stand ten radii apart.
Scene pairs_of(const Scene& scene, double time_step) {
  const auto& radii = scene.particles.radius;
  const auto smallest = static_cast<std::size_t>(std::ranges::min_element(radii) - radii.begin());
  const double r = radii[smallest], speed = impact_speed(scene);
  Scene pairs = scene;
  pairs.particles = {};
  pairs.walls.clear();
  pairs.gravity.setZero();
  pairs.time_step = time_step;
  ParticleState& p = pairs.particles;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double angle = angles[k] * std::numbers::pi / 180;
    for (double side : {-1.0, 1.0}) {
      p.id.push_back(static_cast<std::uint32_t>(p.id.size()));
      p.material.push_back(scene.particles.material[smallest]);
      p.radius.push_back(r);
      p.mass.push_back(scene.particles.mass[smallest]);
      p.position.push_back({side * r, 0, 10 * r * static_cast<double>(k)});
      p.velocity.push_back(-side * speed / 2 * Vector3d(std::cos(angle), std::sin(angle), 0));
      p.angular_velocity.push_back(Vector3d::Zero());
    }
  }
  pairs.domain = {Vector3d::Constant(-20 * r), Vector3d::Constant(20 * r) + Vector3d(0, 0, 40 * r)};
  return pairs;
}

bool have_parted(const ParticleState& state) {
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const Vector3d apart = state.position[2 * k + 1] - state.position[2 * k];
    const Vector3d velocity = state.velocity[2 * k + 1] - state.velocity[2 * k];
    if (apart.norm() < state.radius[2 * k] + state.radius[2 * k + 1] || apart.dot(velocity) < 0) return false;
  }
  return true;
}

}  // namespace

std::vector<CollisionOutcome> collisions(const Scene& scene, const Backend& backend, const Variant& variant,
                                         const BackendOptions& options, double time_step) {
  const Scene pairs = pairs_of(scene, time_step);
  const TimeStepLimits limits = time_step_limits(pairs);
  // The slowest collision is the flattest: its normal speed is a quarter of the others', its contact a third
  // longer.
  const double longest = 3 * limits.hertz_contact_time;
  const auto chunk = static_cast<std::uint64_t>(std::ceil(longest / 12 / time_step));
  const auto simulation = backend.create(pairs, variant, options);
  ParticleState state = pairs.particles;
  for (int k = 0; k < 24 && !have_parted(state); ++k) {
    simulation->step(chunk);
    state = simulation->state();
  }
  const double speed = impact_speed(scene);
  std::vector<CollisionOutcome> outcomes;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const Vector3d velocity = state.velocity[2 * k + 1] - state.velocity[2 * k];
    const double angle = angles[k] * std::numbers::pi / 180;
    outcomes.push_back({angles[k], velocity.x() / (speed * std::cos(angle)),
                        std::atan2(-velocity.y(), velocity.x()) * 180 / std::numbers::pi,
                        state.radius[2 * k] * state.angular_velocity[2 * k].z() / speed});
  }
  return outcomes;
}

CollisionError collision_error(std::span<const CollisionOutcome> seen,
                               std::span<const CollisionOutcome> exact) {
  CollisionError error;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    error.restitution = std::max(error.restitution, std::abs(seen[k].restitution - exact[k].restitution));
    error.rebound_angle =
        std::max(error.rebound_angle, std::abs(seen[k].rebound_angle - exact[k].rebound_angle));
    error.spin = std::max(error.spin, std::abs(seen[k].surface_spin - exact[k].surface_spin));
  }
  return error;
}

}  // namespace warpgrain::cli
