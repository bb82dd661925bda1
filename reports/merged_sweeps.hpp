#pragma once
// Shards of a sweep as one.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "reports/sweep_index.hpp"

namespace warpgrain::reports {

inline constexpr std::string_view sweep_index_name = "index.json";

struct SweepShard {
  std::filesystem::path folder;
  SweepIndex index;  // as it lies there
};

// Reads FOLDER/index.json of each. Throws InputError naming the file.
std::vector<SweepShard> read_shards(std::span<const std::string> folders);

// The cases of all, in the order of the folders; a case that is done in one and not in another is the one
// that is done. Throws InputError naming the folder whose sweep is of another scene, particle count or step
// than the first, or which has a case that is done in one before it with other numbers.
SweepIndex merged(std::span<const SweepShard> shards);

}  // namespace warpgrain::reports
