// Probes of rest: the overlap that carries a weight, and a heap that has to stay as it is.

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "analysis/impact_theory.hpp"
#include "cli/probes/probe_scene.hpp"
#include "cli/probes/probes.hpp"
#include "core/energy.hpp"

namespace warpgrain::cli {
namespace {

constexpr double gravity = 9.81;

double static_overlap(const Scene& scene, ContactModel model, double effective_radius, double force) {
  if (model == ContactModel::simple) return force / scene.model.simple.k_spring;
  return hertz_overlap(scene.contacts.at(0, 0).normal_parameter, effective_radius, force);
}

// Two spheres on each other on a floor at `height`, where theory has them rest; 200 steps later.
ProbeReading stack(const ProbeBench& bench, double youngs_modulus, double height) {
  ProbeScene setting;
  setting.materials[0].youngs_modulus = youngs_modulus;
  setting.restitution = 0.3;
  setting.gravity = {0, 0, -gravity};
  setting.bodies = {{probe_radius, {0, 0, height + probe_radius}, Vector3d::Zero(), 0},
                    {probe_radius, {0, 0, height + 3 * probe_radius}, Vector3d::Zero(), 0}};
  setting.planes.push_back({{0, 0, height}, Vector3d::UnitZ()});
  Scene scene = setting.scene();
  const double weight = scene.particles.mass[0] * gravity;
  const double in_floor = static_overlap(scene, bench.model(), probe_radius, 2 * weight);
  const double expected = static_overlap(scene, bench.model(), probe_radius / 2, weight);
  scene.particles.position[0].z() -= in_floor;
  scene.particles.position[1].z() -= in_floor + expected;
  const ParticleState after = bench.run(scene, 200);
  const double overlap = 2 * probe_radius - (after.position[1] - after.position[0]).norm();
  return {std::abs(overlap - expected) / expected,
          fmt::format("overlap {:.4g} nm, expected {:.4g} nm", 1e9 * overlap, 1e9 * expected)};
}

ProbeReading stack_here(const ProbeBench& bench, double x) { return stack(bench, x, 0); }
ProbeReading stack_at_1_m(const ProbeBench& bench, double x) { return stack(bench, x, 1); }
ProbeReading stack_at_100_m(const ProbeBench& bench, double x) { return stack(bench, x, 100); }

// Three spheres on a floor and one on top, which only friction holds together, as the double reference has
// let them settle.
Scene settled_pyramid(const ProbeBench& bench) {
  ProbeScene setting;
  setting.restitution = 0.3;
  setting.gravity = {0, 0, -gravity};
  const double to_corner = 2 * probe_radius / std::sqrt(3.0);
  for (int k = 0; k < 3; ++k)
    setting.bodies.push_back(
        {probe_radius,
         {to_corner * std::cos(k * 2 * M_PI / 3), to_corner * std::sin(k * 2 * M_PI / 3), probe_radius},
         Vector3d::Zero(),
         0});
  setting.bodies.push_back(
      {probe_radius, {0, 0, probe_radius + 2 * probe_radius * std::sqrt(2.0 / 3)}, Vector3d::Zero(), 0});
  setting.planes.emplace_back();
  Scene scene = setting.scene();
  scene.particles = reference_bench(bench).run(scene, 20000, 20000);
  for (Vector3d& v : scene.particles.velocity) v.setZero();
  for (Vector3d& w : scene.particles.angular_velocity) w.setZero();
  return scene;
}

ProbeReading rest(const ProbeBench& bench, double x) {
  static const Scene scene = settled_pyramid(bench);
  const auto steps = static_cast<std::uint64_t>(std::llround(x));
  const ParticleState after = bench.run(scene, steps, std::max<std::uint64_t>(16, steps / 20));
  Vector3d drift = Vector3d::Zero();  // of all
  for (std::size_t k = 0; k < after.size(); ++k)
    drift += (after.position[k] - scene.particles.position[k]) / static_cast<double>(after.size());
  double moved = 0, crept = 0;  // of one, and beside the others
  for (std::size_t k = 0; k < after.size(); ++k) {
    const Vector3d displacement = after.position[k] - scene.particles.position[k];
    moved = std::max(moved, displacement.norm());
    crept = std::max(crept, (displacement - drift).norm());
  }
  const double weight = scene.particles.mass[0] * gravity;
  const double overlap = static_overlap(scene, bench.model(), probe_radius / 2, weight);
  const Energy energy = energy_of(scene, after);
  const double heat = energy.kinetic_translational + energy.kinetic_rotational;
  return {std::max(moved / overlap, heat / (weight * overlap)),
          fmt::format("drift {:.2g}, creep {:.2g} of an overlap, kinetic energy {:.2g} of the elastic",
                      drift.norm() / overlap, crept / overlap, heat / (weight * overlap))};
}

}  // namespace

std::span<const Probe> rest_probes() {
  constexpr double right = 0.01, degraded = 0.05;
  constexpr std::string_view two = "two spheres of 1 mm on each other on a floor";
  static const std::array<Probe, 4> rows{{
      {"static_overlap", two, "Young's modulus", "Pa", "the overlap that carries the weight", 1e5, 1e11,
       right, degraded, false, false, stack_here},
      {"static_overlap_at_1_m", "the same, 1 m from the origin", "Young's modulus", "Pa",
       "the overlap that carries the weight", 1e5, 1e11, right, degraded, false, false, stack_at_1_m},
      {"static_overlap_at_100_m", "the same, 100 m from the origin", "Young's modulus", "Pa",
       "the overlap that carries the weight", 1e5, 1e11, right, degraded, false, false, stack_at_100_m},
      {"rest", "three spheres of 1 mm on a floor and one on top, held by friction alone", "time at rest",
       "steps", "neither drift nor creep by a hundredth of an overlap, nor heat by one of the elastic energy",
       10, 1e7, right, degraded, true, true, rest},
  }};
  return rows;
}

}  // namespace warpgrain::cli
