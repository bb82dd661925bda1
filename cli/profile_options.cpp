#include "cli/profile_options.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <fmt/format.h>

#include "cli/what_if_options.hpp"
#include "core/error.hpp"
#include "profiler/sass/machine_kernel.hpp"

namespace warpgrain::cli {

namespace {

profiler::WeightOptions::Kind weights_from_name(std::string_view name) {
  using Kind = profiler::WeightOptions::Kind;
  constexpr std::array<std::string_view, 3> names{"ptx", "sass", "auto"};
  constexpr std::array<Kind, 3> kinds{Kind::ptx, Kind::sass, Kind::automatic};
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw_unknown_name("--weights", "value", name, names);
  return kinds[static_cast<std::size_t>(found - names.begin())];
}

profiler::TimelineOptions timelines_from(const std::vector<std::string>& values) {
  constexpr std::array<std::string_view, 5> names{"none", "median", "worst", "costliest", "a warp's number"};
  profiler::TimelineOptions options;
  for (const std::string& value : values) {
    std::uint64_t number = 0;
    const char* const end = value.data() + value.size();
    if (value == "median")
      options.median = true;
    else if (value == "worst")
      options.worst = true;
    else if (value == "costliest")
      options.costliest = true;
    else if (std::from_chars(value.data(), end, number) == std::from_chars_result{end, std::errc()})
      options.warps.push_back(number);
    else if (value != "none" || values.size() > 1)
      throw_unknown_name("--timeline-warps", "value", value, names);
  }
  return options;
}

}  // namespace

void SimulatorOptions::add_to(CLI::App& command) {
  add_option(command, "--weights", weights);
  add_option(command, "--arch", arch);
  add_option(command, "--policy", policy);
  add_option(command, "--width", width);
  add_option(command, "--what-if", what_if);
  add_option(command, "--trace-memory", trace_memory);
  add_option(command, "--timeline-warps", timeline_warps)->delimiter(',');
  add_option(command, "--machine", machine);
  add_flag(command, "--unchecked", unchecked);
  add_option(command, "--max-instructions", max_instructions);
}

std::optional<Machine> SimulatorOptions::load_machine() const {
  return machine.empty() ? std::nullopt : std::optional(warpgrain::load_machine(machine));
}

// Refuses what is none, whether or not there is a ptxas. A machine older than those whose code can be
// replayed stands in the way of no profile: its code is not asked for.
std::string SimulatorOptions::architecture() const {
  if (!arch.empty()) {
    profiler::sass::architecture_number(arch);
    return arch;
  }
  const auto of_machine = load_machine();
  return of_machine && !of_machine->arch.empty() ? of_machine->arch : profiler::WeightOptions{}.arch;
}

profiler::ProfileOptions SimulatorOptions::profile_options(const DeviceOptions& device,
                                                           Progress& progress) const {
  profiler::ProfileOptions options;
  options.weights = {weights_from_name(weights), architecture()};
  options.policy = profiler::merge_policy_from_name(policy, "--policy");
  if (width)
    options.warp_width = *width;
  else if (const auto of_machine = load_machine())
    options.warp_width = static_cast<std::uint32_t>(of_machine->warp_width.value);
  if (options.warp_width < 4 || options.warp_width > 64 || !std::has_single_bit(options.warp_width))
    throw_input_error("--width", fmt::format("{} lanes", options.warp_width), "4, 8, 16, 32 or 64");
  if (!what_if.empty()) options.what_if = what_if_questions(what_if, options.warp_width, options.policy);
  constexpr std::uint64_t largest = std::uint64_t{1} << 40;  // MiB: as good as no limit
  options.trace_memory = std::min(trace_memory, largest) << 20;
  options.timelines = timelines_from(timeline_warps);
  options.footprint = !machine.empty() && load_machine()->cost;
  options.threads = device.threads;
  options.checks = unchecked ? profiler::Checks::off : profiler::Checks::on;
  if (max_instructions == 0) throw_input_error("--max-instructions", "0", "a number above 0");
  options.max_instructions = max_instructions;
  options.progress = [&progress](double fraction) { progress.update("simulating", fraction); };
  return options;
}

void require_timelines(const profiler::TimelineOptions& options,
                       std::span<const profiler::LaunchProfile> launches) {
  std::uint64_t most = 0;
  for (const profiler::LaunchProfile& launch : launches)
    most = std::max<std::uint64_t>(most, launch.counters.warp_sums.size());
  for (const std::uint64_t warp : options.warps)
    if (warp >= most)
      throw_input_error("--timeline-warps", fmt::format("warp {}", warp),
                        fmt::format("less than {}, the warps of the largest launch", most));
}

}  // namespace warpgrain::cli
