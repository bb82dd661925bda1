#pragma once
// Which step "auto" takes: 0.1 of the smaller limit, unless a head-on collision of two of the scene's grains,
// computed in such steps, misses the restitution of its materials.

#include <string>

#include "core/scene.hpp"
#include "core/time_step.hpp"

namespace warpgrain {

struct TimeStepAdvice {
  double step = 0;  // s
  double restitution_error =
      0;               // of the worst pair of materials, at that step, as restitution_error() has it
  std::string reason;  // one line: why this step
};

// Restitution after a collision under eqs. (4), (8), (10) in steps of `share` of the Hertz contact time, less
// `restitution`, as a part of it, or of 0.1 where it is less: the largest over where in a step a contact may
// begin. Takes 0 < restitution <= 1 and a share above 0.
double restitution_error(double restitution, double share);

// `limits` are the scene's.
TimeStepAdvice advise_time_step(const Scene& scene, const TimeStepLimits& limits);

}  // namespace warpgrain
