#pragma once
// What a profiled step's lists cost beside it.

#include <optional>
#include <span>

#include "reports/list_making.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {

// Nothing where the step did not keep lists.
std::optional<reports::ListMaking> list_making_of(std::span<const profiler::LaunchProfile> launches,
                                                  const ProfiledState& left,
                                                  const std::optional<Machine>& machine);

}  // namespace warpgrain::cli
