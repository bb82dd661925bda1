#pragma once
// What the layer has recorded, profiled.

#include <filesystem>
#include <string>
#include <vector>

#include "cli/progress.hpp"
#include "profiler/profile.hpp"

namespace warpgrain::cli {

struct RecordedProfiles {
  std::vector<profiler::LaunchProfile> launches;  // in the order in which they were recorded
  // What the profiles lack or do not say, by kernel: a line each.
  std::vector<std::string> remarks;
};

// Profiles each launch of the folder. Programs are compiled once. What cannot be profiled is remarked upon.
RecordedProfiles profile_recorded(const std::filesystem::path& folder, profiler::ProfileOptions options,
                                  Progress& progress);

}  // namespace warpgrain::cli
