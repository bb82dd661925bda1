#pragma once
// A program that runs under the layer, on the terminal and with the streams of this process.

#include <filesystem>
#include <string>
#include <vector>

#include "cli/record_settings.hpp"

namespace warpgrain::cli {

// The layer as it was built or installed beside this program. Throws InputError where it is not there.
std::filesystem::path find_layer();

// Runs the program to its end and returns its exit status; 128 + signal when one ended it. An interrupt from
// the terminal is for the program alone. Throws InputError when it cannot be started.
int run_recorded(const std::vector<std::string>& words, const std::filesystem::path& layer,
                 const RecordSettings& settings);

}  // namespace warpgrain::cli
