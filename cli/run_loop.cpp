#include "cli/run_loop.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <iostream>
#include <limits>
#include <optional>

#include "cli/interrupt.hpp"
#include "core/rest_criterion.hpp"
#include "core/run_monitor.hpp"
#include "variants/contact_laws.hpp"

namespace warpgrain::cli {
namespace {

constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();

std::uint64_t next_multiple(std::uint64_t step, std::uint64_t interval) {
  return interval ? (step / interval + 1) * interval : never;
}

}  // namespace

RunEnd::AtRest rest_of(const Scene& scene) {
  if (scene.end.at_rest) return *scene.end.at_rest;
  const auto& radius = scene.particles.radius;
  return {1e-3 * *std::min_element(radius.begin(), radius.end()), 1000};
}

RunGoal goal_of(const Scene& scene) {
  RunGoal goal;
  if (scene.end.steps) goal.steps = scene.end.steps;
  if (scene.end.time) goal.steps = static_cast<std::uint64_t>(std::ceil(*scene.end.time / scene.time_step));
  goal.at_rest = scene.end.at_rest;
  return goal;
}

RunOutcome run_to_goal(Simulation& simulation, const RunGoal& goal,
                       const std::function<void(std::uint64_t step)>& sample, Progress& progress) {
  using Clock = std::chrono::steady_clock;
  const std::uint64_t last = goal.steps.value_or(never);
  const std::uint64_t window = goal.at_rest ? goal.at_rest->window : 0;
  const std::uint64_t sample_every = goal.sample_every ? goal.sample_every
                                     : goal.steps      ? std::max<std::uint64_t>(1, *goal.steps / 100)
                                                       : window;
  const double particles = static_cast<double>(simulation.state().size());
  // Chunks short enough for the line of progress to move, long enough for a device not to wait for it.
  const std::uint64_t chunk =
      std::clamp<std::uint64_t>(static_cast<std::uint64_t>(2e6 / (particles + 1)), 1, 10000);

  RunOutcome outcome;
  std::optional<RestCriterion> rest;
  if (goal.at_rest) rest.emplace(*goal.at_rest, simulation.steps_done(), simulation.state().position);
  std::uint64_t step = goal.begin, sampled_at = goal.begin;
  if (step % sample_every == 0) sample(step);
  while (step < last && !outcome.at_rest && !interrupted()) {
    const std::uint64_t until =
        std::min({last, step + chunk, next_multiple(step, sample_every), next_multiple(step, window)});
    const auto start = Clock::now();
    simulation.step(until - step);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    outcome.wall_seconds += seconds;
    const double rate = particles * static_cast<double>(until - step) / seconds;
    step = until;

    if (rest && step % window == 0)
      outcome.at_rest = rest->update(simulation.steps_done(), simulation.state().position);
    if (step % sample_every == 0) {
      sample(step);
      sampled_at = step;
    }
    const double fraction = goal.steps ? static_cast<double>(step) / static_cast<double>(last) : 0;
    progress.update(goal.steps ? "steps" : fmt::format("step {}", step), fraction,
                    rest ? fmt::format("{:.2f} M particle-steps/s, largest displacement {:.3g} m",
                                       rate * 1e-6, rest->displacement())
                         : fmt::format("{:.2f} M particle-steps/s", rate * 1e-6));
  }
  outcome.steps = step;
  outcome.interrupted = step < last && !outcome.at_rest;
  if (sampled_at != step) sample(step);
  return outcome;
}

void warn_of(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) std::cerr << "warning: " << warning << '\n';
}

RunOutcome advance(Scene& scene, const Variant& variant, const BackendOptions& options, const RunGoal& goal,
                   Progress& progress, const std::function<void(std::uint64_t step)>& visit) {
  const auto simulation = backend("opencl").create(scene, variant, options);
  Scene of_the_law = scene;
  of_the_law.model.contact = contact_law(variant).model;
  RunMonitor monitor(of_the_law);
  return run_to_goal(
      *simulation, goal,
      [&](std::uint64_t step) {
        scene.particles = simulation->state();
        warn_of(monitor.look(step, scene.particles));
        make_antisymmetric(scene.particles.contact_history);
        visit(step);
      },
      progress);
}

Scene advanced(const Scene& scene, const Variant& variant, const BackendOptions& options, std::uint64_t steps,
               Progress& progress) {
  Scene result = scene;
  if (steps == 0) return result;
  const RunOutcome outcome =
      advance(result, variant, options, {steps, {}, steps}, progress, [](std::uint64_t) {});
  if (outcome.interrupted) throw Interrupted();
  return result;
}

}  // namespace warpgrain::cli
