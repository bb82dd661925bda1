#pragma once
// How a call wants its warps formed and merged.

#include <CLI/App.hpp>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/machine.hpp"
#include "cli/common_options.hpp"
#include "cli/progress.hpp"
#include "profiler/profile.hpp"

namespace warpgrain::cli {

struct SimulatorOptions {
  std::string weights = "auto";
  std::string arch;  // else the machine's, else sm_90
  std::string policy = "loop_postdom";
  std::optional<std::uint32_t> width;  // else the machine's, else 32
  std::vector<std::string> what_if;
  std::uint64_t trace_memory = 1024;  // MiB
  std::vector<std::string> timeline_warps{"median", "worst", "costliest"};
  std::string machine;  // a file or a name; empty: none
  bool unchecked = false;
  std::uint64_t max_instructions = profiler::RunLimits{}.max_instructions;

  void add_to(CLI::App& command);
  // What ptxas assembles for. Throws InputError where --arch names none.
  std::string architecture() const;
  // None when the call names none. Throws InputError for a file that is no machine.
  std::optional<Machine> load_machine() const;
  // Throws InputError for a policy or width that there is not. `progress` must outlive the profile.
  profiler::ProfileOptions profile_options(const DeviceOptions& device, Progress& progress) const;
};

// Throws InputError for a warp that is asked for by its number and that no launch has.
void require_timelines(const profiler::TimelineOptions& options,
                       std::span<const profiler::LaunchProfile> launches);

}  // namespace warpgrain::cli
