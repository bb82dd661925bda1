#pragma once
// How well a step runs at the states between falling and rest: what pages draw against time.

#include "core/scene.hpp"
#include "profiler/profile.hpp"
#include "reports/state_sample.hpp"
#include "variants/axes.hpp"
#include "variants/backend.hpp"

namespace warpgrain::cli {

// Profiles the step that begins at the scene's particles, which are those after `step` steps. Instructions
// are counted as `how` says; checks and what only a report of its own shows are left out.
reports::StateSample sample_state(const Scene& scene, std::uint64_t step, const Variant& variant,
                                  profiler::ProfileOptions how, const BackendOptions& backend);

}  // namespace warpgrain::cli
