#pragma once
// Arithmetic that rounds towards zero (rz), down (rm) or up (rp): PTX names the rounding in the instruction,
// the host has it in a control register. Devices' own exponentials are built of it.

#include <vector>

#include "profiler/host_functions.hpp"

namespace warpgrain::profiler {

// warpgrain_OPERATION_ROUNDING_TYPE for add, mul, div, fma and sqrt of f32 and f64, and the conversions
// warpgrain_TO_ROUNDING_FROM to f16 of f64, to f32 of f64, s64 and u64, and to f64 of s64 and u64.
std::vector<HostFunction> directed_functions();

}  // namespace warpgrain::profiler
