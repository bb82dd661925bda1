#pragma once
// What a run or a profile says of the model that it computed.

#include <span>
#include <string_view>

#include "core/scene.hpp"
#include "profiler/profile.hpp"
#include "reports/modelled_parts.hpp"
#include "variants/axes.hpp"

namespace warpgrain::cli {

// The host's reference computes all of the model, whatever the variant says.
reports::ModelledParts modelled_parts(const Scene& scene, const Variant& variant, std::string_view backend);

// The variant with all of the model.
Variant with_full_model(Variant variant);

// What a profiled step costs a particle, beside what it costs with the full model; device memory first.
std::vector<reports::Saving> profile_savings(const Scene& scene, const Variant& variant,
                                             std::span<const profiler::LaunchProfile> launches,
                                             std::span<const profiler::LaunchProfile> of_full_model);

// Device memory a particle, beside that of the full model.
reports::Saving memory_saving(const Scene& scene, const Variant& variant);

}  // namespace warpgrain::cli
