#pragma once
// Where the files of the source tree are that tests read.

#include <string>

namespace warpgrain {

// The path of a file or folder from its name relative to the root of the tree.
std::string source_path(const std::string& relative);

}  // namespace warpgrain
