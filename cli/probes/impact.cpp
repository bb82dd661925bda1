#include "cli/probes/impact.hpp"

#include <cmath>
#include <numbers>

#include "analysis/impact_theory.hpp"

namespace warpgrain::cli {
namespace {

double effective_mass(const Scene& scene) {
  const auto& mass = scene.particles.mass;
  return mass.size() < 2 ? mass[0] : mass[0] * mass[1] / (mass[0] + mass[1]);
}

double effective_radius(const Scene& scene) {
  const auto& radius = scene.particles.radius;
  return radius.size() < 2 ? radius[0] : radius[0] * radius[1] / (radius[0] + radius[1]);
}

const ContactParameters& parameters_of(const Scene& scene) {
  const auto& material = scene.particles.material;
  return scene.contacts.at(material[0], material.size() < 2 ? 0 : material[1]);
}

}  // namespace

double contact_time(const Scene& scene, ContactModel model, double speed) {
  if (model == ContactModel::simple)
    return std::numbers::pi * std::sqrt(effective_mass(scene) / scene.model.simple.k_spring);
  return hertz_impact(parameters_of(scene).normal_parameter, effective_radius(scene), effective_mass(scene),
                      speed)
      .duration;
}

double expected_restitution(const Scene& scene, ContactModel model, double restitution) {
  if (model == ContactModel::practical) return restitution;
  const SimpleParameters& simple = scene.model.simple;
  return linear_restitution(simple.k_spring, simple.k_damping, effective_mass(scene));
}

Scene HeadOn::scene() const {
  ProbeScene complete = setting;
  const ProbeMaterial& first = complete.materials.front();
  if (density_ratio != 1) {
    ProbeMaterial second = first;
    second.density *= density_ratio;
    complete.materials.push_back(second);
  }
  const double second_radius = radius * radius_ratio;
  complete.bodies.push_back({radius, place - Vector3d(radius, 0, 0), {speed / 2, 0, 0}, 0});
  complete.bodies.push_back({second_radius,
                             place + Vector3d(second_radius, 0, 0),
                             {-speed / 2, 0, 0},
                             density_ratio == 1 ? std::size_t{0} : std::size_t{1}});
  return complete.scene();
}

ImpactResult collide(const ProbeBench& bench, const Scene& scene, double steps_per_contact) {
  const ParticleState& before = scene.particles;
  const double reach = before.radius[0] + before.radius[1];
  const double approach = before.velocity[0].x() - before.velocity[1].x();
  const auto is_over = [&](const ParticleState& state) {
    return state.velocity[0].x() < state.velocity[1].x() &&
           (state.position[1] - state.position[0]).norm() > reach;
  };
  const auto steps = static_cast<std::uint64_t>(std::ceil(8 * steps_per_contact)) + 2;
  const auto look_every = static_cast<std::uint64_t>(std::ceil(steps_per_contact / 3)) + 1;
  const ParticleState after = bench.run(scene, steps, look_every, is_over);
  ImpactResult result;
  result.restitution = (after.velocity[1].x() - after.velocity[0].x()) / approach;
  Vector3d momentum = Vector3d::Zero();
  for (std::size_t k = 0; k < 2; ++k) momentum += before.mass[k] * (after.velocity[k] - before.velocity[k]);
  result.momentum_error =
      momentum.norm() / (effective_mass(scene) * approach * (1 + std::abs(result.restitution)));
  return result;
}

}  // namespace warpgrain::cli
