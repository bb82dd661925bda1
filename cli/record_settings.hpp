#pragma once
// What `warpgrain record` asks of its layer. It goes through the environment of the program that is recorded,
// which is how the OpenCL loader itself is told of layers.

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace warpgrain::cli {

struct RecordSettings {
  std::filesystem::path folder;      // where launches go; empty: nothing is recorded
  std::vector<std::string> kernels;  // names of kernels, with a shell's wildcards; none: all
  std::uint64_t first = std::numeric_limits<std::uint64_t>::max();    // launches of each kernel
  std::uint64_t every = 1;                                            // and of these every so many-th
  std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();  // work-items of a launch
  std::uint64_t memory = std::uint64_t{4} << 30;                      // bytes that all launches may take
};

// As NAME=VALUE.
std::vector<std::string> environment_of(const RecordSettings& settings);

// Of this process. Without a folder where `warpgrain record` has not started it.
RecordSettings settings_of_environment();

// What became of a launch: a line of the folder's index, which the layer writes and `record` reads.
struct RecordedLaunch {
  std::string kernel;
  std::string file;    // launch file in the folder; empty: it was not recorded
  std::string remark;  // why not, or what the file does not say
};

inline constexpr const char* record_index = "launches.tsv";

std::string index_line(const RecordedLaunch& launch);
std::vector<RecordedLaunch> read_index(const std::filesystem::path& folder);

}  // namespace warpgrain::cli
