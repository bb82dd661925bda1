#pragma once
// How a call wants its warps formed and merged.

#include <CLI/App.hpp>
#include <cstdint>
#include <string>

#include "cli/common_options.hpp"
#include "cli/progress.hpp"
#include "profiler/profile.hpp"

namespace warpgrain::cli {

struct SimulatorOptions {
  std::string policy = "loop_postdom";
  std::uint32_t width = 32;

  void add_to(CLI::App& command);
  // Throws InputError for a policy or width that there is not. `progress` must outlive the profile.
  profiler::ProfileOptions profile_options(const DeviceOptions& device, Progress& progress) const;
};

}  // namespace warpgrain::cli
