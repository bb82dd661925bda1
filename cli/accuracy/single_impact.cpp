#include "cli/accuracy/single_impact.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/time_step.hpp"

namespace warpgrain::cli {
namespace {

double overlap_of(const Scene& scene, const ParticleState& state) {
  if (!scene.walls.empty())
    return state.radius[0] - wall_proximity(scene.walls[0], state.position[0]).distance;
  return state.radius[0] + state.radius[1] - (state.position[1] - state.position[0]).norm();
}

}  // namespace

SingleImpact single_impact(const Scene& scene, const Backend& backend, const Variant& variant,
                           const BackendOptions& options, std::uint64_t look_every) {
  const auto simulation = backend.create(scene, variant, options);
  const auto most = static_cast<std::uint64_t>(
      std::ceil(10 * time_step_limits(scene).hertz_contact_time / scene.time_step));
  SingleImpact impact;
  std::uint64_t touching = 0;
  while (simulation->steps_done() < most) {
    simulation->step(look_every);
    impact.after = simulation->state();
    const double overlap = overlap_of(scene, impact.after);
    impact.largest_overlap = std::max(impact.largest_overlap, overlap);
    if (overlap <= 0 && touching > 0) break;
    if (overlap <= 0) continue;
    ++touching;
    impact.moments.push_back(
        {static_cast<double>(touching * look_every) * scene.time_step, simulation->forces().force[0].norm()});
  }
  impact.duration = static_cast<double>(touching * look_every) * scene.time_step;
  return impact;
}

double force_at(const SingleImpact& impact, double time) {
  SingleImpact::Moment before;
  for (const SingleImpact::Moment& moment : impact.moments) {
    if (moment.time >= time)
      return std::lerp(before.force, moment.force, (time - before.time) / (moment.time - before.time));
    before = moment;
  }
  return 0;
}

void set_angle(Scene& scene, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  scene.particles.velocity[0] =
      scene.particles.velocity[0].norm() * Vector3d(std::sin(angle), 0, -std::cos(angle));
}

}  // namespace warpgrain::cli
