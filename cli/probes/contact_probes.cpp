// Probes of one force evaluation: overlaps from one ulp to complete, contacts up to the slots there are.

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "analysis/force_error.hpp"
#include "cli/probes/probe_scene.hpp"
#include "cli/probes/probes.hpp"

namespace warpgrain::cli {
namespace {

// eqs. (4), (8); of the simple model eq. (1)
double expected_force(const Scene& scene, ContactModel model, double overlap) {
  if (model == ContactModel::simple) return scene.model.simple.k_spring * overlap;
  return scene.contacts.at(0, 0).normal_parameter * std::sqrt(overlap * probe_radius / 2) * overlap;
}

ProbeReading overlap(const ProbeBench& bench, double x) {
  ProbeScene setting;
  setting.bodies.push_back({probe_radius, {-probe_radius, 0, 0}, Vector3d::Zero(), 0});
  setting.bodies.push_back({probe_radius, {probe_radius - x * probe_radius, 0, 0}, Vector3d::Zero(), 0});
  const Scene scene = setting.scene();
  const ForceState forces = bench.forces(scene);
  const double expected = expected_force(scene, bench.model(), x * probe_radius);
  // What the other one feels is as large, and opposite.
  const double off =
      std::max(std::abs(-forces.force[0].x() - expected), (forces.force[0] + forces.force[1]).norm()) /
      expected;
  return {off, fmt::format("force {:.4g} N, expected {:.4g}", forces.force[1].x(), expected)};
}

// Spheres spread evenly around one in the middle, each pressed in by a hundredth: on a spiral whose steps
// are golden angles.
ProbeReading contacts(const ProbeBench& bench, double x) {
  const auto n = static_cast<int>(std::lround(x));
  ProbeScene setting;
  setting.bodies.emplace_back();
  for (int k = 0; k < n; ++k) {
    const double z = 1 - (2 * k + 1.0) / n, turn = std::numbers::pi * (3 - std::sqrt(5.0)) * k;
    const double ring = std::sqrt(1 - z * z);
    setting.bodies.push_back(
        {probe_radius, Vector3d(ring * std::cos(turn), ring * std::sin(turn), z) * (1.99 * probe_radius),
         Vector3d::Zero(), 0});
  }
  const Scene scene = setting.scene();
  const ForceState seen = bench.forces(scene), exact = reference_bench(bench).forces(scene);
  const double off = force_error(scene.particles, seen, exact).force.maximum;
  return {off, fmt::format("forces of {} contacts off by {:.2g} of the largest", n, off)};
}

}  // namespace

std::span<const Probe> contact_probes() {
  constexpr double right = 0.01, degraded = 0.05;
  static const std::array<Probe, 3> rows{{
      {"overlap_small", "two spheres of 1 mm that overlap, the point of contact at the origin", "overlap",
       "radii", "the force of the law, and its opposite on the other", 1e-2, 1e-15, right, degraded, false,
       false, overlap},
      {"overlap_large", "two spheres of 1 mm that overlap, until their centres coincide", "overlap", "radii",
       "the force of the law, and its opposite on the other", 1e-2, 2, right, degraded, false, false,
       overlap},
      {"contacts", "a sphere touched by others all around", "contacts", "", "forces as in double", 1, 24,
       right, degraded, false, false, contacts},
  }};
  return rows;
}

}  // namespace warpgrain::cli
