#include "analysis/impact_theory.hpp"

#include <cmath>
#include <numbers>

namespace warpgrain {

HertzImpact hertz_impact(double normal_parameter, double effective_radius, double effective_mass,
                         double speed) {
  const double c = normal_parameter * std::sqrt(effective_radius);
  HertzImpact impact;
  impact.largest_overlap = std::pow(1.25 * effective_mass * speed * speed / c, 0.4);
  impact.largest_force = c * std::pow(impact.largest_overlap, 1.5);
  impact.duration = 2.9432 * impact.largest_overlap / speed;
  return impact;
}

double hertz_force(const HertzImpact& impact, double time) {
  if (!(time > 0 && time < impact.duration)) return 0;
  constexpr int steps = 2000;  // leaves 1e-7
  const double step = 2.9432 * time / impact.duration / steps;
  const auto acceleration = [](double x) { return x > 0 ? -1.25 * x * std::sqrt(x) : 0.0; };
  double x = 0, speed = 1;
  for (int k = 0; k < steps; ++k) {
    speed += step / 2 * acceleration(x);
    x += step * speed;
    speed += step / 2 * acceleration(x);
  }
  return x > 0 ? impact.largest_force * x * std::sqrt(x) : 0;
}

double hertz_overlap(double normal_parameter, double effective_radius, double force) {
  return std::pow(force / (normal_parameter * std::sqrt(effective_radius)), 2.0 / 3);
}

SlidingImpact sliding_impact(double normal_speed, double tangential_speed, double radius, double restitution,
                             double friction) {
  const double lost = friction * (1 + restitution) * normal_speed;
  return {tangential_speed - lost, 2.5 * lost / radius, tangential_speed >= 3.5 * lost};
}

double linear_restitution(double spring, double damping, double effective_mass) {
  const double ratio = damping / (2 * std::sqrt(spring * effective_mass));
  if (ratio >= 1) return 0;
  return std::exp(-std::numbers::pi * ratio / std::sqrt(1 - ratio * ratio));
}

}  // namespace warpgrain
