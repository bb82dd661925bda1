#pragma once
// The options of clBuildProgram.

#include <string>
#include <string_view>
#include <vector>

namespace warpgrain::profiler {

// Splits at blanks outside of quotes and backslashes. Throws InputError for an open quote and for an option
// that is not one of clBuildProgram's.
std::vector<std::string> split_build_options(std::string_view options);

}  // namespace warpgrain::profiler
