#pragma once
// The particles of a profiled step as a report draws them.

#include <optional>
#include <span>

#include "profiler/profile.hpp"
#include "reports/bed.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {

inline constexpr std::uint64_t default_bed_particles = 20000;

// `left` is what the step of `scene` left. At most `most` particles: of more, those nearest to the middle of
// the shorter horizontal side, so that the drawing is as dense as the bed. None for `most` = 0 and for scenes
// without particles.
std::optional<reports::Bed> bed_of(const Scene& scene, const Variant& variant,
                                   std::span<const profiler::LaunchProfile> launches,
                                   const ProfiledState& left, std::uint64_t most);

}  // namespace warpgrain::cli
