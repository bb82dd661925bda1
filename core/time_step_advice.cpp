#include "core/time_step_advice.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace warpgrain {
namespace {

constexpr double tolerated = 0.01;
// Damped so much, contacts end in a crawl; restitution is a matter of tenths of a percent of the speed then.
constexpr double least_restitution = 0.1;

// m* = 1, C_kn sqrt(R*) = 1 and a speed of 1, so that E* sqrt(R*) = 3/4.
const double hertz_time = 2.87 * std::pow(1 / (0.75 * 0.75), 0.2);

// The speed at which the two part, the contact beginning `phase` of a step after the start of one.
double rebound(double damping_parameter, double step, double phase) {
  double overlap = -phase * step, speed = 1;
  while (speed > 0 || overlap > 0) {
    if (overlap > 0) {
      const double stiffness = std::sqrt(overlap);
      speed -= step * (stiffness * overlap + damping_parameter * std::sqrt(stiffness) * speed);
    }
    overlap += step * speed;
  }
  return -speed;
}

// The inverse of damping_parameter_of_restitution(); 0 for what leaves none.
double restitution_of(double damping_parameter) {
  if (damping_parameter >= std::sqrt(5.0)) return 0;
  return std::exp(-std::numbers::pi * damping_parameter /
                  std::sqrt(5 - damping_parameter * damping_parameter));
}

struct WorstPair {
  double error = 0, restitution = 1;
};

WorstPair worst_pair(const Scene& scene, double share) {
  WorstPair worst;
  const std::size_t n = scene.contacts.n_materials();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i; j < n; ++j) {
      const double restitution = restitution_of(scene.contacts.at(i, j).damping_parameter);
      if (restitution == 0) continue;
      const double error = restitution_error(restitution, share);
      if (error > worst.error) worst = {error, restitution};
    }
  return worst;
}

}  // namespace

double restitution_error(double restitution, double share) {
  const double damping_parameter = damping_parameter_of_restitution(restitution);
  double worst = 0;
  constexpr int phases = 8;
  for (int k = 0; k < phases; ++k)
    worst = std::max(
        worst, std::abs(rebound(damping_parameter, share * hertz_time, static_cast<double>(k) / phases) -
                        restitution));
  return worst / std::max(restitution, least_restitution);
}

TimeStepAdvice advise_time_step(const Scene& scene, const TimeStepLimits& limits) {
  TimeStepAdvice advice;
  advice.step = automatic_time_step(limits);
  const std::string_view smaller =
      limits.rayleigh_time < limits.hertz_contact_time ? "Rayleigh time" : "Hertz contact time";
  advice.reason = fmt::format("0.1 of the {}", smaller);
  if (scene.model.contact != ContactModel::practical || !std::isfinite(limits.hertz_contact_time))
    return advice;
  const auto share = [&] { return advice.step / limits.hertz_contact_time; };
  const WorstPair at_first = worst_pair(scene, share());
  WorstPair worst = at_first;
  while (worst.error > tolerated) {
    advice.step *= 0.8;
    worst = worst_pair(scene, share());
  }
  advice.restitution_error = worst.error;
  advice.reason +=
      at_first.error > tolerated
          ? fmt::format(
                " would put a restitution of {:.3g} off by {:.2g} %; with this step it is "
                "right within {:.2g} %",
                at_first.restitution, 100 * at_first.error, 100 * worst.error)
          : fmt::format(", with which restitution comes out right within {:.2g} %", 100 * worst.error);
  return advice;
}

}  // namespace warpgrain
