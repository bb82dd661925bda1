#pragma once
// PTX whose approximate functions are as far off as a device's may be. The simulator computes them exactly
// (and rounds once), while the PTX ISA promises bounds only: a result that matters must hold for any device
// that keeps them.

#include <string>
#include <string_view>

namespace warpgrain::profiler {

// The module with the modifier `.displaced` on every sqrt.approx.f32, rsqrt.approx.f32, rcp.approx.f32,
// div.approx.f32 and div.full.f32: a modifier of this project's own, which ptx/ takes (ptx/displacement.hpp).
std::string with_displaced_approximations(std::string_view ptx);

}  // namespace warpgrain::profiler
