#include "core/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

#include "core/scene_domain.hpp"

namespace warpgrain {
namespace {

double rayleigh_time(const Material& material, double radius) {
  const double shear_modulus = material.youngs_modulus / (2 * (1 + material.poisson_ratio));
  return std::numbers::pi * radius * std::sqrt(material.density / shear_modulus) /
         (0.1631 * material.poisson_ratio + 0.8766);
}

double bound_of_relative_speeds(const Scene& scene) {
  const auto& velocity = scene.particles.velocity;
  Vector3d least = scene.walls.empty() && !velocity.empty() ? velocity[0] : Vector3d::Zero();
  Vector3d greatest = least;
  for (const Vector3d& v : velocity) {
    least = least.cwiseMin(v);
    greatest = greatest.cwiseMax(v);
  }
  return (greatest - least).norm();
}

// How far a particle can fall: within the box around the scene, or onto a plane that faces upwards.
double height_of_fall(const Scene& scene) {
  const Vector3d down = scene.gravity.normalized();  // zero without gravity
  const Box box = box_around(scene);
  double height = (box.upper - box.lower).dot(down.cwiseAbs());
  for (const Wall& wall : scene.walls) {
    const double steepness = -wall.normal.dot(down);
    if (wall.kind != WallKind::plane || !(steepness > 0.1)) continue;
    for (const Vector3d& position : scene.particles.position)
      height = std::max(height, (position - wall.point).dot(wall.normal) / steepness);
  }
  return height;
}

}  // namespace

TimeStepLimits time_step_limits(const Scene& scene) {
  const ParticleState& p = scene.particles;
  TimeStepLimits limits;
  limits.rayleigh_time = std::numeric_limits<double>::infinity();
  std::size_t smallest = 0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    limits.rayleigh_time =
        std::min(limits.rayleigh_time, rayleigh_time(scene.materials[p.material[k]], p.radius[k]));
    if (p.radius[k] < p.radius[smallest]) smallest = k;
  }
  limits.impact_speed =
      std::max(bound_of_relative_speeds(scene), std::sqrt(2 * scene.gravity.norm() * height_of_fall(scene)));

  double normal_parameter = 0;
  for (std::size_t i = 0; i < scene.contacts.n_materials(); ++i)
    for (std::size_t j = i; j < scene.contacts.n_materials(); ++j)
      normal_parameter = std::max(normal_parameter, scene.contacts.at(i, j).normal_parameter);
  const double effective_mass = p.mass[smallest] / 2, effective_radius = p.radius[smallest] / 2;
  const double effective_modulus = 0.75 * normal_parameter;
  limits.hertz_contact_time =
      2.87 * std::pow(effective_mass * effective_mass /
                          (effective_radius * effective_modulus * effective_modulus * limits.impact_speed),
                      0.2);
  return limits;
}

double automatic_time_step(const TimeStepLimits& limits) {
  return 0.1 * std::min(limits.rayleigh_time, limits.hertz_contact_time);
}

std::string time_step_warning(double time_step, const TimeStepLimits& limits) {
  const double share_of_rayleigh = time_step / limits.rayleigh_time;
  const double share_of_hertz = time_step / limits.hertz_contact_time;
  if (!(std::max(share_of_rayleigh, share_of_hertz) > 0.2)) return {};
  return fmt::format(
      "the time step {:.4g} s is {:.2g} of the Rayleigh time and {:.2g} of the Hertz contact time at {:.3g} "
      "m/s; "
      "expected at most 0.2 of either",
      time_step, share_of_rayleigh, share_of_hertz, limits.impact_speed);
}

}  // namespace warpgrain
