#pragma once
// The second level of accuracy: single collisions of two grains of the scene.

#include <span>
#include <vector>

#include "cli/accuracy/setting.hpp"

namespace warpgrain::cli {

// What is left of one collision.
struct CollisionOutcome {
  double angle = 0;          // of the impact, from the normal [degrees]
  double restitution = 0;    // of the normal velocity
  double rebound_angle = 0;  // of the relative velocity of the centres, from the normal [degrees]
  double surface_spin = 0;   // r w of the first, as a part of the speed of impact
};

// Collisions at 0, 15, 45 and 75 degrees and the scene's speed of impact, all in one run of pairs far from
// each other, in steps of `time_step` [s]. Throws InputError as the back end does.
std::vector<CollisionOutcome> collisions(const Scene& scene, const Backend& backend, const Variant& variant,
                                         const BackendOptions& options, double time_step);

// The largest differences over the angles.
struct CollisionError {
  double restitution = 0;    // as a part of the speed of impact
  double rebound_angle = 0;  // degrees
  double spin = 0;           // of r w, as a part of the speed of impact
};
CollisionError collision_error(std::span<const CollisionOutcome> seen,
                               std::span<const CollisionOutcome> exact);

}  // namespace warpgrain::cli
