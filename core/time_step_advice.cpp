#include "core/time_step_advice.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <numbers>

namespace warpgrain {
namespace {

constexpr double tolerated = 0.01;
// Where places are rounded so that it shows, what comes out is a matter of chance, of which few throws are
// looked at here.
constexpr double tolerated_of_chance = 0.006;
// Of the largest overlap; below, rounding places changes restitution by less than 1e-4.
constexpr double least_rounding = 1e-5;
// Damped so much, contacts end in a crawl; restitution is a matter of tenths of a percent of the speed then.
constexpr double least_restitution = 0.1;
// Steps that are tried, each 0.8 of the one before: down to a hundredth.
constexpr int most_tries = 20;

// m* = 1, C_kn sqrt(R*) = 1 and a speed of 1, so that E* sqrt(R*) = 3/4.
const double hertz_time = 2.87 * std::pow(1 / (0.75 * 0.75), 0.2);
const double hertz_largest_overlap = std::pow(1.25, 0.4);

// The acceleration of two bodies that overlap and approach each other, m* = 1.
using Law = std::function<double(double overlap, double speed)>;

// The speed at which the two part that met at a speed of 1, the contact beginning `phase` of a step after the
// start of one. Both are at multiples of `spacing`, where that is not 0. What never parts leaves no speed.
double rebound(const Law& law, double step, double phase, double spacing, double longest) {
  const auto rounded = [&](double x) { return spacing > 0 ? spacing * std::round(x / spacing) : x; };
  double speed = 1;
  // Places of the surfaces that meet, of the left and the right body.
  double left = 0, right = rounded(phase * step);
  for (double time = 0; time < longest; time += step) {
    const double overlap = left - right;
    if (speed < 0 && overlap <= 0) return -speed;
    if (overlap > 0) speed -= step * law(overlap, speed);
    left = rounded(left + step * speed / 2);
    right = rounded(right - step * speed / 2);
  }
  return 0;
}

double worst_error(const Law& law, double restitution, double step, double spacing, double longest) {
  double worst = 0;
  constexpr int phases = 8;
  for (int k = 0; k < phases; ++k)
    worst = std::max(
        worst, std::abs(rebound(law, step, static_cast<double>(k) / phases, spacing, longest) - restitution));
  return worst / std::max(restitution, least_restitution);
}

// The inverse of damping_parameter_of_restitution(); 0 for what leaves none.
double restitution_of(double damping_parameter) {
  if (damping_parameter >= std::sqrt(5.0)) return 0;
  return std::exp(-std::numbers::pi * damping_parameter /
                  std::sqrt(5 - damping_parameter * damping_parameter));
}

// Two of the smallest spheres, as the limits have it.
struct Pair {
  double mass = 0, radius = 0;  // effective
};

Pair smallest_pair(const ParticleState& p) {
  const auto k = static_cast<std::size_t>(std::ranges::min_element(p.radius) - p.radius.begin());
  return {p.mass[k] / 2, p.radius[k] / 2};
}

struct WorstPair {
  double error = 0, restitution = 1;
  bool is_rounded = false;  // places, for some pair
};

double shown(double rounding) { return rounding < least_rounding ? 0 : rounding; }

WorstPair worst_practical(const Scene& scene, const TimeStepLimits& limits, double step, double spacing) {
  const Pair pair = smallest_pair(scene.particles);
  WorstPair worst;
  const std::size_t n = scene.contacts.n_materials();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i; j < n; ++j) {
      const ContactParameters& contact = scene.contacts.at(i, j);
      const double restitution = restitution_of(contact.damping_parameter);
      if (restitution == 0) continue;
      const double unit = std::pow(pair.mass * limits.impact_speed * limits.impact_speed /
                                       (contact.normal_parameter * std::sqrt(pair.radius)),
                                   0.4);
      const double rounding = shown(spacing / (unit * hertz_largest_overlap));
      const double error = restitution_error(restitution, step / limits.hertz_contact_time, rounding);
      worst.is_rounded |= rounding > 0;
      if (error > worst.error) worst = {error, restitution, worst.is_rounded};
    }
  return worst;
}

WorstPair worst_simple(const Scene& scene, const TimeStepLimits& limits, double step, double spacing) {
  const SimpleParameters& simple = scene.model.simple;
  const double mass = smallest_pair(scene.particles).mass;
  const double ratio = simple.k_damping / (2 * std::sqrt(simple.k_spring * mass));
  if (!(simple.k_spring > 0) || ratio >= 1) return {};
  const double restitution = std::exp(-std::numbers::pi * ratio / std::sqrt(1 - ratio * ratio));
  const double frequency = std::sqrt(simple.k_spring / mass);
  const double rounding = shown(spacing * frequency / limits.impact_speed);
  return {linear_restitution_error(restitution, step * frequency / std::numbers::pi, rounding), restitution,
          rounding > 0};
}

}  // namespace

double restitution_error(double restitution, double share, double place_spacing) {
  const double damping_parameter = damping_parameter_of_restitution(restitution);
  const Law law = [=](double overlap, double speed) {
    const double stiffness = std::sqrt(overlap);
    return stiffness * overlap + damping_parameter * std::sqrt(stiffness) * speed;
  };
  return worst_error(law, restitution, share * hertz_time, place_spacing * hertz_largest_overlap,
                     50 * hertz_time);
}

double linear_restitution_error(double restitution, double share, double place_spacing) {
  const double log_e = std::log(restitution);
  const double ratio = -log_e / std::hypot(std::numbers::pi, log_e);
  const Law law = [=](double overlap, double speed) { return overlap + 2 * ratio * speed; };
  return worst_error(law, restitution, share * std::numbers::pi, place_spacing, 50 * std::numbers::pi);
}

TimeStepAdvice advise_time_step(const Scene& scene, const TimeStepLimits& limits,
                                const StepArithmetic& arithmetic) {
  TimeStepAdvice advice;
  advice.step = automatic_time_step(limits);
  advice.reason =
      fmt::format("0.1 of the {}",
                  limits.rayleigh_time < limits.hertz_contact_time ? "Rayleigh time" : "Hertz contact time");
  if (!std::isfinite(limits.hertz_contact_time)) return advice;
  const auto worst_at = [&](double step) {
    return scene.model.contact == ContactModel::practical
               ? worst_practical(scene, limits, step, arithmetic.place_spacing)
               : worst_simple(scene, limits, step, arithmetic.place_spacing);
  };
  const WorstPair at_first = worst_at(advice.step);
  const double bound = at_first.is_rounded ? tolerated_of_chance : tolerated;
  WorstPair best = at_first;
  double step = advice.step;
  for (int k = 0; k < most_tries && best.error > bound; ++k) {
    step *= 0.8;
    if (const WorstPair here = worst_at(step); here.error < best.error) {
      best = here;
      advice.step = step;
    }
  }
  advice.restitution_error = best.error;
  advice.is_right = best.error <= bound;
  if (at_first.error <= bound)
    advice.reason +=
        fmt::format(", with which restitution comes out right within {:.2g} %", 100 * best.error);
  else
    advice.reason += fmt::format(
        " would put a restitution of {:.3g} off by {:.2g} %; with this step it is right within {:.2g} %",
        at_first.restitution, 100 * at_first.error, 100 * best.error);
  if (!advice.is_right)
    advice.reason += fmt::format(", and no step does better: places in {} are {:.2g} m apart here",
                                 arithmetic.name, arithmetic.place_spacing);
  return advice;
}

}  // namespace warpgrain
