#pragma once
// How a call wants its warps formed and merged.

#include <CLI/App.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "cli/common_options.hpp"
#include "cli/progress.hpp"
#include "profiler/profile.hpp"

namespace warpgrain::cli {

struct SimulatorOptions {
  std::string policy = "loop_postdom";
  std::uint32_t width = 32;
  std::vector<std::string> what_if;
  std::uint64_t trace_memory = 1024;  // MiB

  void add_to(CLI::App& command);
  // Throws InputError for a policy or width that there is not. `progress` must outlive the profile.
  profiler::ProfileOptions profile_options(const DeviceOptions& device, Progress& progress) const;
};

}  // namespace warpgrain::cli
