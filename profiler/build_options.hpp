#pragma once
// Options for compilers of kernels.

#include <string>
#include <string_view>
#include <vector>

namespace warpgrain::profiler {

// Splits at blanks outside of quotes and backslashes. Throws InputError for an open quote.
std::vector<std::string> split_words(std::string_view options);

// The same, for options of clBuildProgram and no others.
std::vector<std::string> split_build_options(std::string_view options);

}  // namespace warpgrain::profiler
