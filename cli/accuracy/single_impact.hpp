#pragma once
// The first impact of particle 0 of a scene, against a wall or particle 1.

#include "cli/accuracy/setting.hpp"

namespace warpgrain::cli {

struct SingleImpact {
  double largest_overlap = 0;  // m, of those looked at
  double duration = 0;         // s, to the nearest look
  ParticleState after;
};

// Looks after every `look_every` steps until the two have parted, for ten times the Hertz contact time at
// most.
SingleImpact single_impact(const Scene& scene, const Backend& backend, const Variant& variant,
                           const BackendOptions& options, std::uint64_t look_every);

// Turns the velocity of particle 0 so that it comes at `degrees` from the normal z, along x.
void set_angle(Scene& scene, double degrees);

}  // namespace warpgrain::cli
