#pragma once
// What the variants of an accuracy study share: the scene, a state of it, and how each is run.

#include <cstdint>
#include <optional>
#include <string>

#include "analysis/machine.hpp"
#include "core/scene.hpp"
#include "variants/backend.hpp"

namespace warpgrain::cli {

struct AccuracySetting {
  Scene scene;                     // as loaded
  Scene at_step;                   // the same with its particles some steps later, where contacts are
  Scene costed;                    // the same again, or a larger one: of which costs are counted
  std::optional<Machine> machine;  // for which times are predicted
  BackendOptions backend;
  std::uint64_t divergence_steps = 0;  // how long trajectories are compared, in steps of the scene
  std::uint64_t timed_steps = 0;
};

// A variant at a time step.
struct AccuracyCase {
  Variant variant;
  double step_factor = 1;  // of the scene's step
  bool always_simulated = false;
  std::string name() const;
  // Where its numbers come from. Functions that may be approximate are the CPU driver's exact ones: where the
  // variant asks for other than the default, or `always_simulated`, the simulator computes them as far off as
  // a GPU's may be.
  const Backend& runs_on() const;
};

// The scene with the case's step.
Scene with_step(const Scene& scene, double step_factor);

}  // namespace warpgrain::cli
