#pragma once
// The launches of one time step, profiled in the simulator.

#include <filesystem>
#include <vector>

#include "core/scene.hpp"
#include "profiler/profile.hpp"
#include "variants/axes.hpp"
#include "variants/backend.hpp"

namespace warpgrain {

// What a profiled step leaves.
struct ProfiledState {
  ParticleState particles;            // by id
  std::vector<std::uint32_t> places;  // of these in the arrays that the kernels worked on, [n_particles]
  // Where the step kept lists: the launches of another step that make map and lists anew, and after how many
  // steps they have to be, if the fastest particle goes on as it does. None where nothing moves.
  std::vector<profiler::LaunchProfile> list_launches;
  std::uint64_t steps_between_lists = 0;
};

// Profiles one time step (integrate ... forces from walls) of `variant`, beginning at the scene's particle
// state. One entry a kernel launch, in the order of launching. Throws as Simulation::step does, and
// InputError when this build has no simulator. Of `backend` the kernel folder counts, and the threads where
// `options` leaves them open. What-if questions that sort threads by a count are answered for the kernels
// that have it; that none has is an InputError. The first launch of each kernel is exported to
// `export_folder`, unless that is empty. `left` is filled in unless it is null.
std::vector<profiler::LaunchProfile> profile_step(const Scene& scene, const Variant& variant,
                                                  const profiler::ProfileOptions& options,
                                                  const BackendOptions& backend = {},
                                                  const std::filesystem::path& export_folder = {},
                                                  ProfiledState* left = nullptr);

// Throws InputError for a question that sorts threads by a count which none of the launches has.
void require_answers(const std::vector<profiler::WhatIf>& questions,
                     const std::vector<profiler::LaunchProfile>& launches);

}  // namespace warpgrain
