#include "cli/profile_options.hpp"

#include <array>
#include <bit>
#include <fmt/format.h>
#include <string_view>

#include "core/error.hpp"

namespace warpgrain::cli {

void SimulatorOptions::add_to(CLI::App& command) {
  add_option(command, "--policy", policy);
  add_option(command, "--width", width);
}

profiler::ProfileOptions SimulatorOptions::profile_options(const DeviceOptions& device,
                                                           Progress& progress) const {
  using profiler::MergePolicy;
  constexpr std::array policies{MergePolicy::loop_postdom, MergePolicy::ipdom, MergePolicy::min_pc};
  std::array<std::string_view, policies.size()> names;
  for (std::size_t k = 0; k < policies.size(); ++k) names[k] = profiler::merge_policy_name(policies[k]);

  profiler::ProfileOptions options;
  const auto found = std::find(names.begin(), names.end(), policy);
  if (found == names.end()) throw_unknown_name("--policy", "policy", policy, names);
  options.policy = policies[static_cast<std::size_t>(found - names.begin())];
  if (width < 4 || width > 64 || !std::has_single_bit(width))
    throw_input_error("--width", fmt::format("{} lanes", width), "4, 8, 16, 32 or 64");
  options.warp_width = width;
  options.threads = device.threads;
  options.progress = [&progress](double fraction) { progress.update("simulating", fraction); };
  return options;
}

}  // namespace warpgrain::cli
