#pragma once
// The launches of one time step, profiled in the simulator.

#include <vector>

#include "core/scene.hpp"
#include "profiler/profile.hpp"
#include "variants/axes.hpp"
#include "variants/backend.hpp"

namespace warpgrain {

// Profiles one time step (integrate ... forces from walls) of `variant`, beginning at the scene's particle
// state. One entry a kernel launch, in the order of launching. Throws as Simulation::step does, and
// InputError when this build has no simulator. Of `backend` the kernel folder counts, and the threads where
// `options` leaves them open. What-if questions that sort threads by a count are answered for the kernels
// that have it; that none has is an InputError.
std::vector<profiler::LaunchProfile> profile_step(const Scene& scene, const Variant& variant,
                                                  const profiler::ProfileOptions& options,
                                                  const BackendOptions& backend = {});

}  // namespace warpgrain
