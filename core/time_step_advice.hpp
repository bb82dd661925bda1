#pragma once
// Which step "auto" takes: 0.1 of the smaller limit, unless a head-on collision of two of the scene's grains,
// computed in such steps by the scene's model and in the arithmetic at hand, misses the restitution of its
// materials.

#include <string>

#include "core/scene.hpp"
#include "core/time_step.hpp"

namespace warpgrain {

// How a run computes.
struct StepArithmetic {
  std::string name = "double";
  double place_spacing = 0;  // m, between neighbouring places where the scene is; 0: finer than matters
};

struct TimeStepAdvice {
  double step = 0;  // s
  double restitution_error =
      0;                 // of the worst pair of materials, at that step, as restitution_error() has it
  std::string reason;    // one line: why this step
  bool is_right = true;  // no step is, where places are too far apart; the reason says so
};

// Restitution after a collision in steps of `share` of the Hertz contact time, under eqs. (4), (8), (10),
// less `restitution`, as a part of it, or of 0.1 where it is less: the largest over where in a step a contact
// may begin. Takes 0 < restitution <= 1 and a share above 0.
// `place_spacing`: of both spheres' places, in the largest overlap of such a collision without damping.
double restitution_error(double restitution, double share, double place_spacing = 0);
// The same under eq. (1), in steps of `share` of a contact, pi sqrt(m* / k).
double linear_restitution_error(double restitution, double share, double place_spacing = 0);

// `limits` are the scene's.
TimeStepAdvice advise_time_step(const Scene& scene, const TimeStepLimits& limits,
                                const StepArithmetic& arithmetic = {});

}  // namespace warpgrain
