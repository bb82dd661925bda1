#include "cli/list_making_of.hpp"

namespace warpgrain::cli {

std::optional<reports::ListMaking> list_making_of(std::span<const profiler::LaunchProfile> launches,
                                                  const ProfiledState& left,
                                                  const std::optional<Machine>& machine) {
  if (left.list_launches.empty()) return std::nullopt;
  return reports::list_making(launches, left.list_launches, left.steps_between_lists, machine);
}

}  // namespace warpgrain::cli
