#include "core/run_monitor.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

#include "core/error.hpp"

namespace warpgrain {
namespace {

std::string place_of(std::uint64_t step, std::uint32_t particle) {
  return fmt::format("step {}: particle {}", step, particle);
}

std::string partner_text(std::uint32_t partner) {
  return partner & wall_partner_bit ? fmt::format("wall {}", partner & ~wall_partner_bit)
                                    : fmt::format("particle {}", partner);
}

std::size_t fastest(const ParticleState& state) {
  std::size_t found = 0;
  for (std::size_t k = 1; k < state.size(); ++k)
    if (state.velocity[k].squaredNorm() > state.velocity[found].squaredNorm()) found = k;
  return found;
}

}  // namespace

RunMonitor::RunMonitor(const Scene& scene, const MonitorLimits& limits) : scene_(scene), limits_(limits) {
  scene_.particles = {};
}

std::vector<std::string> RunMonitor::look(std::uint64_t step, const ParticleState& state) {
  std::vector<std::string> warnings;
  if (state.size() == 0) return warnings;
  require_numbers(step, state);
  DeepestContact deepest;
  energy_ = energy_of(scene_, state, &deepest);
  judge_overlap(step, deepest, warnings);
  judge_energy(step, state, warnings);
  return warnings;
}

void RunMonitor::require_numbers(std::uint64_t step, const ParticleState& state) const {
  const auto fail = [&](std::size_t k, std::string_view what) {
    throw_simulation_error(place_of(step, state.id[k]), what);
  };
  for (std::size_t k = 0; k < state.size(); ++k) {
    const Vector3d& x = state.position[k];
    if (!x.allFinite()) fail(k, "has a position that is not a finite number");
    if (!state.velocity[k].allFinite()) fail(k, "has a velocity that is not a finite number");
    if (!state.angular_velocity[k].allFinite())
      fail(k, "has an angular velocity that is not a finite number");
    if ((x.array() < scene_.domain.lower.array()).any() || (x.array() > scene_.domain.upper.array()).any())
      fail(k, "left the domain");
  }
}

void RunMonitor::judge_overlap(std::uint64_t step, const DeepestContact& deepest,
                               std::vector<std::string>& warnings) {
  if (deepest.share < limits_.overlap_warning) return;
  const std::string what =
      fmt::format("overlaps {} by {:.3g} of its radius", partner_text(deepest.partner_id), deepest.share);
  if (deepest.share >= limits_.overlap_error)
    throw_simulation_error(place_of(step, deepest.particle_id), what,
                           "less: stiffer material, slower particles or a smaller time step");
  if (warned_of_overlap_) return;
  warned_of_overlap_ = true;
  warnings.push_back(fmt::format("{} {}; contact laws hold below {:.2g}", place_of(step, deepest.particle_id),
                                 what, limits_.overlap_warning));
}

void RunMonitor::judge_energy(std::uint64_t step, const ParticleState& state,
                              std::vector<std::string>& warnings) {
  const Vector3d middle = (scene_.domain.lower + scene_.domain.upper) / 2;
  const double mass = std::accumulate(state.mass.begin(), state.mass.end(), 0.0);
  const double noise =
      1e-6 * mass * scene_.gravity.norm() * (scene_.domain.upper - scene_.domain.lower).norm();
  const double total = energy_.total() + mass * scene_.gravity.dot(middle);
  least_total_ = has_looked_ ? std::min(least_total_, total) : total;
  largest_internal_ = std::max(largest_internal_, energy_.total() - energy_.gravitational);
  has_looked_ = true;
  const double gained = total - least_total_ - noise;
  const double growth = largest_internal_ > 0 ? gained / largest_internal_ : 0;
  if (growth < limits_.energy_warning) return;
  const std::size_t k = fastest(state);
  const std::string what = fmt::format(
      "the energy has grown by {:.3g} J without a source, {:.2g} of all kinetic and elastic energy", gained,
      growth);
  const std::string particle =
      fmt::format("{} is the fastest, at {:.3g} m/s", place_of(step, state.id[k]), state.velocity[k].norm());
  if (growth >= limits_.energy_error)
    throw_simulation_error(particle, what, "a smaller time step, or more digits");
  if (warned_of_energy_) return;
  warned_of_energy_ = true;
  warnings.push_back(fmt::format("{}: {}", particle, what));
}

}  // namespace warpgrain
