// Probes of single collisions: what restitution and momentum make of stiffness, speed, size, mass and place.

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "cli/probes/impact.hpp"
#include "cli/probes/probes.hpp"

namespace warpgrain::cli {
namespace {

// What makes restitution right to a tenth of what counts as right: a linear spring is hard from the first
// step on, and damping that leaves nothing is over in a small part of a contact.
constexpr double steps_a_contact = 50, steps_a_linear_contact = 150, steps_a_damped_contact = 300;

ProbeReading judge_head_on(const ProbeBench& bench, const HeadOn& head_on, double steps = steps_a_contact) {
  if (bench.model() == ContactModel::simple) steps = std::max(steps, steps_a_linear_contact);
  Scene scene = head_on.scene();
  scene.time_step = contact_time(scene, bench.model(), head_on.speed) / steps;
  const double expected = expected_restitution(scene, bench.model(), head_on.setting.restitution);
  const ImpactResult result = collide(bench, scene, steps);
  const double off = std::abs(result.restitution - expected) / std::max(expected, 0.1);
  if (result.momentum_error > off)
    return {result.momentum_error,
            fmt::format("{:.2g} of the momentum exchanged is lost", result.momentum_error)};
  return {off, fmt::format("restitution {:.4g}, expected {:.4g}", result.restitution, expected)};
}

ProbeReading stiffness(const ProbeBench& bench, double x) {
  HeadOn head_on;
  head_on.setting.materials[0].youngs_modulus = x;
  head_on.speed = 0.01;  // so that the softest is pressed in by a tenth
  return judge_head_on(bench, head_on);
}

ProbeReading speed(const ProbeBench& bench, double x) {
  HeadOn head_on;
  head_on.speed = x;
  return judge_head_on(bench, head_on);
}

ProbeReading size_ratio(const ProbeBench& bench, double x) {
  HeadOn head_on;
  head_on.radius_ratio = x;
  return judge_head_on(bench, head_on);
}

ProbeReading mass_ratio(const ProbeBench& bench, double x) {
  HeadOn head_on;
  head_on.density_ratio = x;
  return judge_head_on(bench, head_on);
}

ProbeReading distance(const ProbeBench& bench, double x) {
  HeadOn head_on;
  head_on.place = {2e-3 * x, 0, 0};
  return judge_head_on(bench, head_on);
}

ProbeReading radius(const ProbeBench& bench, double x) {
  HeadOn head_on;
  head_on.radius = x;
  return judge_head_on(bench, head_on);
}

ProbeReading restitution(const ProbeBench& bench, double x) {
  HeadOn head_on;
  head_on.setting.restitution = x;
  return judge_head_on(bench, head_on, steps_a_damped_contact);
}

// A sphere that meets a wall at 45 degrees, held against the double reference.
ProbeReading friction(const ProbeBench& bench, double x) {
  ProbeScene setting;
  setting.friction = x;
  const double r = 1e-3, speed = 1;
  setting.bodies.push_back({r, {0, 0, r}, Vector3d(1, 0, -1) * (speed / std::sqrt(2.0)), 0});
  setting.planes.emplace_back();
  Scene scene = setting.scene();
  scene.time_step = contact_time(scene, bench.model(), speed) / steps_a_contact;
  const auto is_over = [&](const ParticleState& state) {
    return state.velocity[0].z() > 0 && state.position[0].z() > r;
  };
  const auto after = [&](const ProbeBench& where) { return where.run(scene, 1500, 16, is_over); };
  const ParticleState seen = after(bench), exact = after(reference_bench(bench));
  const double off = std::max((seen.velocity[0] - exact.velocity[0]).norm(),
                              r * (seen.angular_velocity[0] - exact.angular_velocity[0]).norm()) /
                     speed;
  return {off, fmt::format("spin {:.4g} rad/s, in double {:.4g}", seen.angular_velocity[0].y(),
                           exact.angular_velocity[0].y())};
}

// Nothing but the normal component changes at a wall without friction.
ProbeReading frictionless(const ProbeBench& bench, double x) {
  ProbeScene setting;
  setting.friction = 0;
  const double r = 1e-3, speed = 1, angle = x * std::numbers::pi / 180;
  setting.bodies.push_back({r, {0, 0, r}, Vector3d(std::sin(angle), 0, -std::cos(angle)) * speed, 0});
  setting.planes.emplace_back();
  setting.room = 400;  // along which it goes on while it touches
  Scene scene = setting.scene();
  const double steps = bench.model() == ContactModel::simple ? steps_a_linear_contact : steps_a_contact;
  scene.time_step = contact_time(scene, bench.model(), speed * std::cos(angle)) / steps;
  const auto is_over = [&](const ParticleState& state) {
    return state.velocity[0].z() > 0 && state.position[0].z() > r;
  };
  const ParticleState after = bench.run(scene, 1500, 16, is_over);
  const double off = std::max(std::abs(after.velocity[0].x() - scene.particles.velocity[0].x()),
                              r * after.angular_velocity[0].norm()) /
                     speed;
  return {off, fmt::format("tangential velocity {:.4g} m/s, was {:.4g}", after.velocity[0].x(),
                           scene.particles.velocity[0].x())};
}

// Densities and moduli in the same proportion: times and speeds stay what they are, masses and forces shrink
// until arithmetic has no normal numbers for them.
ProbeReading subnormal(const ProbeBench& bench, double x) {
  HeadOn head_on;
  head_on.setting.materials[0].density *= x;
  head_on.setting.materials[0].youngs_modulus *= x;
  return judge_head_on(bench, head_on);
}

constexpr std::string_view keeps_restitution = "restitution as the material has it, momentum kept";

}  // namespace

std::span<const Probe> impact_probes() {
  constexpr double right = 0.01, degraded = 0.05;
  static const std::array<Probe, 15> rows{{
      {"stiffness_high", "two spheres of 1 mm meet at 1 cm/s", "Young's modulus", "Pa", keeps_restitution,
       1e7, 1e11, right, degraded, false, false, stiffness},
      {"stiffness_low", "two spheres of 1 mm meet at 1 cm/s", "Young's modulus", "Pa", keeps_restitution, 1e7,
       1e3, right, degraded, false, false, stiffness},
      {"speed_low", "two spheres of 1 mm and 10 MPa meet", "speed", "m/s", keeps_restitution, 1, 1e-9, right,
       degraded, false, false, speed},
      {"speed_high", "two spheres of 1 mm and 10 MPa meet", "speed", "m/s", keeps_restitution, 1, 1e4, right,
       degraded, false, false, speed},
      {"size_ratio", "a sphere of 1 mm meets a larger one at 1 m/s", "ratio of radii", "", keeps_restitution,
       1, 100, right, degraded, false, false, size_ratio},
      {"mass_ratio", "a sphere of 1 mm meets a heavier one of its size at 1 m/s", "ratio of masses", "",
       keeps_restitution, 1, 1e6, right, degraded, false, false, mass_ratio},
      {"radius_small", "two spheres meet at 1 m/s", "radius", "m", keeps_restitution, 1e-3, 1e-15, right,
       degraded, false, false, radius},
      {"radius_large", "two spheres meet at 1 m/s", "radius", "m", keeps_restitution, 1e-3, 1e6, right,
       degraded, false, false, radius},
      {"distance_from_origin", "two spheres of 1 mm meet at 1 m/s, away from the origin", "distance",
       "diameters", keeps_restitution, 1, 1e6, right, degraded, false, false, distance},
      {"restitution_low", "two spheres of 1 mm meet at 1 m/s", "restitution", "", keeps_restitution, 0.8,
       1e-6, right, degraded, false, false, restitution},
      {"restitution_high", "two spheres of 1 mm meet at 1 m/s", "restitution", "", keeps_restitution, 0.8, 1,
       right, degraded, false, false, restitution},
      {"friction_none", "a sphere of 1 mm meets a wall without friction at 1 m/s", "angle from the normal",
       "degrees", "the tangential velocity stays, no spin appears", 15, 85, right, degraded, true, false,
       frictionless},
      {"friction_low", "a sphere of 1 mm meets a wall at 45 degrees and 1 m/s", "friction coefficient", "",
       "velocity and spin as in double", 0.5, 1e-6, right, degraded, true, false, friction},
      {"friction_high", "a sphere of 1 mm meets a wall at 45 degrees and 1 m/s", "friction coefficient", "",
       "velocity and spin as in double", 0.5, 1e3, right, degraded, true, false, friction},
      {"subnormal", "two spheres of 1 mm meet at 1 m/s, in ever larger units of mass", "masses and forces",
       "those in SI", keeps_restitution, 1, 1e-44, right, degraded, false, false, subnormal},
  }};
  return rows;
}

}  // namespace warpgrain::cli
