#pragma once
// The first impact of particle 0 of a scene, against a wall or particle 1.

#include <vector>

#include "cli/accuracy/setting.hpp"

namespace warpgrain::cli {

struct SingleImpact {
  // At one look: time since the contact began, and the force on particle 0.
  struct Moment {
    double time = 0, force = 0;  // s, N
  };
  double largest_overlap = 0;  // m, of those looked at
  double duration = 0;         // s, to the nearest look
  ParticleState after;
  std::vector<Moment> moments;  // those that touch
};

// The force `time` seconds after the contact began, straight between two looks; 0 before and behind.
double force_at(const SingleImpact& impact, double time);

// Looks after every `look_every` steps until the two have parted, for ten times the Hertz contact time at
// most.
SingleImpact single_impact(const Scene& scene, const Backend& backend, const Variant& variant,
                           const BackendOptions& options, std::uint64_t look_every);

// Turns the velocity of particle 0 so that it comes at `degrees` from the normal z, along x.
void set_angle(Scene& scene, double degrees);

}  // namespace warpgrain::cli
