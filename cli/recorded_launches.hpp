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
  bool interrupted = false;  // Ctrl-C has come before the last
};

// Removes what a program has left half written in the folder when a signal ended it.
void remove_unfinished(const std::filesystem::path& folder);

// Profiles each launch of the folder, until Ctrl-C comes in a command that watches for it. Programs are
// compiled once. What cannot be profiled is remarked upon.
RecordedProfiles profile_recorded(const std::filesystem::path& folder, profiler::ProfileOptions options,
                                  Progress& progress);

}  // namespace warpgrain::cli
