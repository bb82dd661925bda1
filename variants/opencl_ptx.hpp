#pragma once
// The PTX that NVIDIA's OpenCL compiler makes, which it returns as a program's binary.

#include <optional>
#include <string>
#include <string_view>

namespace warpgrain {

// Without the zero bytes behind the text, and with 0 in place of the registers %envregN: they hold the
// offsets of OpenCL's launches, and garbage where another driver launches. None if the binary is no PTX.
std::optional<std::string> ptx_of_binary(std::string_view binary);

}  // namespace warpgrain
