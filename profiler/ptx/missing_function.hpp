#pragma once
// Functions that PTX calls and does not define: what a message says of them.

#include <string>
#include <string_view>

namespace warpgrain::profiler::ptx {

// "'read_imagef': images and samplers are not carried", by the names that clang gives OpenCL's functions.
std::string missing_function(std::string_view symbol);

}  // namespace warpgrain::profiler::ptx
