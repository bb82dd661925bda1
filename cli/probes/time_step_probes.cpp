// Probes of the time step, in Rayleigh times.

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <random>

#include "cli/probes/impact.hpp"
#include "cli/probes/probes.hpp"
#include "core/energy.hpp"
#include "core/time_step.hpp"

namespace warpgrain::cli {
namespace {

// Pairs beside each other that begin their contacts a quarter of a step apart: how a contact falls between
// two steps is chance.
ProbeReading impact(const ProbeBench& bench, double x) {
  constexpr int n_pairs = 4;
  const double speed = 1;
  ProbeScene setting;
  for (int pair = 0; pair < n_pairs; ++pair)
    for (double side : {-1.0, 1.0})
      setting.bodies.push_back(
          {probe_radius, {side * probe_radius, 6 * probe_radius * pair, 0}, {-side * speed / 2, 0, 0}, 0});
  Scene scene = setting.scene();
  scene.time_step = x * time_step_limits(scene).rayleigh_time;
  for (int pair = 0; pair < n_pairs; ++pair)
    scene.particles.position[2 * pair + 1].x() += speed * scene.time_step * pair / n_pairs;
  const auto velocity = [](const ParticleState& state, int pair) {
    return state.velocity[2 * pair + 1].x() - state.velocity[2 * pair].x();
  };
  const auto is_over = [&](const ParticleState& state) {
    for (int pair = 0; pair < n_pairs; ++pair)
      if (velocity(state, pair) < 0 ||
          (state.position[2 * pair + 1] - state.position[2 * pair]).norm() < 2 * probe_radius)
        return false;
    return true;
  };
  const double contact = contact_time(scene, bench.model(), speed) / scene.time_step;
  const auto look_every = static_cast<std::uint64_t>(std::ceil(contact / 3));
  const auto steps = static_cast<std::uint64_t>(std::ceil(4 * contact)) + 10;
  const ParticleState after = bench.run(scene, steps, look_every, is_over);
  const double expected = expected_restitution(scene, bench.model(), setting.restitution);
  double worst = expected;
  for (int pair = 0; pair < n_pairs; ++pair)
    if (std::abs(velocity(after, pair) / speed - expected) > std::abs(worst - expected))
      worst = velocity(after, pair) / speed;
  return {std::abs(worst - expected) / expected,
          fmt::format("restitution {:.4g}, expected {:.4g}, with {:.3g} steps a contact", worst, expected,
                      contact)};
}

double hertz_times(ProbeScene setting) {
  const TimeStepLimits limits = time_step_limits(setting.scene());
  return limits.rayleigh_time / limits.hertz_contact_time;
}

double hertz_times_of_impact() {
  ProbeScene setting;
  for (double side : {-1.0, 1.0})
    setting.bodies.push_back({probe_radius, {side * probe_radius, 0, 0}, {-side / 2, 0, 0}, 0});
  return hertz_times(setting);
}

ProbeScene oblique_scene() {
  ProbeScene setting;
  setting.bodies.push_back({probe_radius, {0, 0, probe_radius}, Vector3d(1, 0, -1) * std::sqrt(0.5), 0});
  setting.planes.emplace_back();
  return setting;
}

double hertz_times_of_oblique() { return hertz_times(oblique_scene()); }

ParticleState oblique_after(const ProbeBench& bench, double share_of_rayleigh_time) {
  Scene scene = oblique_scene().scene();
  scene.time_step = share_of_rayleigh_time * time_step_limits(scene).rayleigh_time;
  const double contact = contact_time(scene, bench.model(), 1) / scene.time_step;
  return bench.run(scene, static_cast<std::uint64_t>(std::ceil(4 * contact)) + 10,
                   static_cast<std::uint64_t>(std::ceil(contact / 3)), [](const ParticleState& state) {
                     return state.velocity[0].z() > 0 && state.position[0].z() > probe_radius;
                   });
}

// In small steps; computed once for each model.
const ParticleState& fine_oblique(const ProbeBench& bench) {
  static std::map<ContactModel, ParticleState> known;
  const auto [found, is_new] = known.try_emplace(bench.model());
  if (is_new) found->second = oblique_after(reference_bench(bench), 1e-3);
  return found->second;
}

ProbeReading oblique(const ProbeBench& bench, double x) {
  const ParticleState seen = oblique_after(bench, x);
  const ParticleState& fine = fine_oblique(bench);
  const double spin = seen.angular_velocity[0].y(), expected = fine.angular_velocity[0].y();
  return {std::max((seen.velocity[0] - fine.velocity[0]).norm(), probe_radius * std::abs(spin - expected)),
          fmt::format("spin {:.4g} rad/s, with small steps {:.4g}", spin, expected)};
}

// 27 undamped spheres pressed into a box so that each overlaps six partners by a thousandth, and shaken.
ProbeReading packing(const ProbeBench& bench, double x) {
  constexpr double pressed = 1e-3;
  ProbeScene setting;
  setting.restitution = 1;
  const double spacing = 2 * probe_radius * (1 - pressed), wall = spacing + probe_radius * (1 - pressed);
  std::mt19937 random(1);
  const auto shake = [&] { return 1e-3 * (static_cast<double>(random()) / 0x1p31 - 1); };
  for (int k = 0; k < 27; ++k)
    setting.bodies.push_back({probe_radius,
                              Vector3d(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1) * spacing,
                              {shake(), shake(), shake()},
                              0});
  for (int axis = 0; axis < 3; ++axis)
    for (double side : {-1.0, 1.0})
      setting.planes.push_back({Vector3d::Unit(axis) * (side * wall), Vector3d::Unit(axis) * -side});
  Scene scene = setting.scene();
  scene.model.contact = bench.model();
  scene.time_step = x * time_step_limits(scene).rayleigh_time;
  const double before = energy_of(scene, scene.particles).total();
  const double after = energy_of(scene, bench.run(scene, 200, 20)).total();
  return {std::max(0.0, after / before - 1), fmt::format("energy {:.4g} J, was {:.4g} J", after, before)};
}

}  // namespace

std::span<const Probe> time_step_probes() {
  constexpr double right = 0.01, degraded = 0.05;
  constexpr double from = 0.02, to = 5, blown_up = 0.5;
  static const std::array<Probe, 4> rows{{
      {"time_step_impact", "two spheres of 1 mm and 10 MPa meet at 1 m/s; a contact lasts 2.4 Rayleigh times",
       "time step", "Rayleigh times", "restitution as the material has it", from, to, right, degraded, false,
       false, impact, "Hertz contact times", hertz_times_of_impact},
      {"time_step_oblique", "a sphere of 1 mm meets a wall at 45 degrees and 1 m/s", "time step",
       "Rayleigh times", "velocity and spin as with small steps", from, to, right, degraded, false, false,
       oblique, "Hertz contact times", hertz_times_of_oblique},
      {"time_step_packing", "27 undamped spheres pressed into a box", "time step", "Rayleigh times",
       "no energy appears", from, to, right, degraded, false, false, packing},
      {"time_step_blow_up", "the same 27 spheres", "time step", "Rayleigh times",
       "the energy does not grow by half", from, to, blown_up, blown_up, false, false, packing},
  }};
  return rows;
}

}  // namespace warpgrain::cli
