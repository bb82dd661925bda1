#pragma once
// What a call of `warpgrain accuracy` asks for.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/common_options.hpp"
#include "reports/accuracy_report.hpp"

namespace warpgrain::cli {

inline constexpr std::array<std::string_view, 4> level_names{"force", "collision", "trajectory", "ensemble"};
inline constexpr std::array<std::string_view, 3> study_names{"variants", "impacts", "convergence"};
inline constexpr std::string_view variants_study = study_names.front();

struct AccuracyOptions {
  SceneOptions scene;
  std::vector<std::string> axis, levels{level_names.begin(), level_names.begin() + 3};
  std::vector<double> step_factors{1};
  bool resume = false;
  std::uint64_t at_step = 1500, timed_steps = 50, trajectory_steps = 200, seeds = 4;
  DeviceOptions device;
  OutputOptions output;
  std::string cost{reports::cost_names.front()}, machine;
  std::vector<std::string> measured;
  std::optional<std::uint64_t> cost_particles;
  std::string study = "variants", html;
  bool markdown = false, simulate = false;

  bool has(std::string_view level) const { return std::ranges::find(levels, level) != levels.end(); }
};

// Throws InputError naming the option.
void require_sensible_options(const AccuracyOptions& options);

}  // namespace warpgrain::cli
