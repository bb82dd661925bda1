#include "cli/profile_options.hpp"

#include <algorithm>
#include <bit>
#include <fmt/format.h>

#include "cli/what_if_options.hpp"
#include "core/error.hpp"

namespace warpgrain::cli {

void SimulatorOptions::add_to(CLI::App& command) {
  add_option(command, "--policy", policy);
  add_option(command, "--width", width);
  add_option(command, "--what-if", what_if);
  add_option(command, "--trace-memory", trace_memory);
}

profiler::ProfileOptions SimulatorOptions::profile_options(const DeviceOptions& device,
                                                           Progress& progress) const {
  profiler::ProfileOptions options;
  options.policy = profiler::merge_policy_from_name(policy, "--policy");
  if (width < 4 || width > 64 || !std::has_single_bit(width))
    throw_input_error("--width", fmt::format("{} lanes", width), "4, 8, 16, 32 or 64");
  options.warp_width = width;
  if (!what_if.empty()) options.what_if = what_if_questions(what_if, width, options.policy);
  constexpr std::uint64_t largest = std::uint64_t{1} << 40;  // MiB: as good as no limit
  options.trace_memory = std::min(trace_memory, largest) << 20;
  options.threads = device.threads;
  options.progress = [&progress](double fraction) { progress.update("simulating", fraction); };
  return options;
}

}  // namespace warpgrain::cli
