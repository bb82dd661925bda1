#pragma once
// PTX text -> Module. Syntax: NVIDIA, "Parallel Thread Execution ISA". Debug sections are skipped; what a
// program cannot be run without and is not carried is refused.

#include <string_view>

#include "profiler/ptx/module.hpp"

namespace warpgrain::profiler::ptx {

// Throws InputError naming `where`, the PTX line, what stands there and what was expected.
Module parse(std::string_view text, std::string_view where);

}  // namespace warpgrain::profiler::ptx
