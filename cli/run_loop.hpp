#pragma once
// Advances a simulation to the end that a scene or a call asks for.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cli/progress.hpp"
#include "core/scene.hpp"
#include "variants/backend.hpp"

namespace warpgrain::cli {

struct RunGoal {
  // Steps to do; without a limit the run ends at rest only.
  std::optional<std::uint64_t> steps;
  // Ends earlier when no particle has moved farther than this over the window.
  std::optional<RunEnd::AtRest> at_rest;
  std::uint64_t sample_every = 0;  // steps between two samples; 0 takes a hundredth of the run, or the window
  // Steps that an earlier call has done, of those above: samples are taken where the whole run has them.
  std::uint64_t begin = 0;
};

// The goal of the scene's time.end.
RunGoal goal_of(const Scene& scene);
// Rest as the scene states it; else no particle moving more than a thousandth of the smallest radius in 1000
// steps.
RunEnd::AtRest rest_of(const Scene& scene);

struct RunOutcome {
  std::uint64_t steps = 0;  // done in the end, those of an earlier call among them
  double wall_seconds = 0;  // of the steps alone
  bool at_rest = false;
  bool interrupted = false;  // by Ctrl-C, in a command that watches for it
};

// Calls `sample` with the number of steps done: before the first step, every `sample_every` steps and after
// the last step, which an interrupt makes that of the present chunk.
RunOutcome run_to_goal(Simulation& simulation, const RunGoal& goal,
                       const std::function<void(std::uint64_t step)>& sample, Progress& progress);

// A line each on stderr: what a monitor (core/run_monitor.hpp) or a check has found.
void warn_of(const std::vector<std::string>& warnings);

// Runs the particles of the scene to the goal, with `variant` on the OpenCL device: what later runs and
// profiles start from, so that a monitor looks at it. `visit` sees the scene at every sample.
RunOutcome advance(Scene& scene, const Variant& variant, const BackendOptions& options, const RunGoal& goal,
                   Progress& progress, const std::function<void(std::uint64_t step)>& visit);
// The scene after `steps` steps, without samples. Throws Interrupted when Ctrl-C has come, in a command that
// watches for it.
Scene advanced(const Scene& scene, const Variant& variant, const BackendOptions& options, std::uint64_t steps,
               Progress& progress);

}  // namespace warpgrain::cli
