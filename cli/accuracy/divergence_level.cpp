#include "cli/accuracy/divergence_level.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain::cli {
namespace {

constexpr double parted = 0.01;      // radii
constexpr std::uint64_t looks = 20;  // over the time compared

// So that steps a quarter to four times the scene's divide the interval.
std::uint64_t steps_an_interval(const AccuracySetting& setting) {
  return std::max<std::uint64_t>(4, (setting.divergence_steps / looks + 3) / 4 * 4);
}

}  // namespace

Trajectory reference_trajectory(const AccuracySetting& setting) {
  const std::uint64_t steps = steps_an_interval(setting);
  Variant variant;
  variant.set("precision", "fp64");
  if (setting.scene.model.contact == ContactModel::simple) variant.set("contact", "simple");
  const auto simulation = backend("host").create(setting.at_step, variant, setting.backend);
  Trajectory trajectory;
  trajectory.interval = static_cast<double>(steps) * setting.at_step.time_step;
  trajectory.positions.push_back(simulation->state().position);
  for (std::uint64_t k = 0; k < looks; ++k) {
    simulation->step(steps);
    trajectory.positions.push_back(simulation->state().position);
  }
  return trajectory;
}

Divergence divergence(const AccuracySetting& setting, const AccuracyCase& which,
                      const Trajectory& reference) {
  const Scene scene = with_step(setting.at_step, which.step_factor);
  const double quotient = reference.interval / scene.time_step;
  const auto steps = static_cast<std::uint64_t>(std::llround(quotient));
  if (steps == 0 || std::abs(quotient - static_cast<double>(steps)) > 1e-6)
    throw_input_error("--step-factor", fmt::format("{}", which.step_factor),
                      fmt::format("a part of {} steps, to compare trajectories at equal times",
                                  steps_an_interval(setting)));
  const auto simulation = which.runs_on().create(scene, which.variant, setting.backend);
  Divergence result;
  for (std::size_t k = 1; k < reference.positions.size(); ++k) {
    simulation->step(steps);
    const ParticleState state = simulation->state();
    double farthest = 0, squares = 0;
    for (std::size_t i = 0; i < state.size(); ++i) {
      const double distance = (state.position[i] - reference.positions[k][i]).norm() / state.radius[i];
      farthest = std::max(farthest, distance);
      squares += distance * distance;
    }
    result.compared = reference.interval * static_cast<double>(k);
    result.root_mean_square = std::sqrt(squares / static_cast<double>(state.size()));
    if (farthest > parted && !result.time) result.time = result.compared;
    if (result.root_mean_square > 1) break;  // nothing more to learn
  }
  return result;
}

}  // namespace warpgrain::cli
