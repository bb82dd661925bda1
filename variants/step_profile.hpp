#pragma once
// The launches of one time step, profiled in the simulator.

#include <vector>

#include "core/scene.hpp"
#include "profiler/profile.hpp"
#include "variants/axes.hpp"

namespace warpgrain {

// Profiles one time step (integrate ... forces from walls) of `variant`, beginning at the scene's particle
// state. One entry a kernel launch, in the order of launching. Throws as Simulation::step does.
std::vector<profiler::LaunchProfile> profile_step(const Scene& scene, const Variant& variant,
                                                  const profiler::ProfileOptions& options);

}  // namespace warpgrain
