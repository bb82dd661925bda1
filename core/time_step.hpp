#pragma once
// How large a time step may be.

#include <string>

#include "core/scene.hpp"

namespace warpgrain {

struct TimeStepLimits {
  // pi r sqrt(rho/G) / (0.1631 nu + 0.8766), the least of all particles [s]
  double rayleigh_time = 0;
  // 2.87 (m*^2 / (R* E*^2 v))^0.2 of two of the smallest particles [s]; E* = 3/4 C_kn of the stiffest pair of
  // materials
  double hertz_contact_time = 0;  // infinite when nothing moves and nothing falls
  // v above [m/s]: the larger of a bound of the initial relative speeds (the diagonal of the box around all
  // velocities, resting walls included) and of the speed after a free fall through the height of the scene
  double impact_speed = 0;
};

TimeStepLimits time_step_limits(const Scene& scene);

// What "auto" means: 0.1 of the smaller limit [s].
double automatic_time_step(const TimeStepLimits& limits);

// One line when `time_step` exceeds 0.2 of either limit, else empty.
std::string time_step_warning(double time_step, const TimeStepLimits& limits);

}  // namespace warpgrain
