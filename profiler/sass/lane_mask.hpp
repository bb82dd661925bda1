#pragma once
// Lanes of a warp as bits.

#include <bit>
#include <cstdint>

namespace warpgrain::profiler::sass {

using Mask = std::uint32_t;

template <class F>
void for_lanes(Mask mask, F&& f) {
  for (; mask != 0; mask &= mask - 1) f(static_cast<std::uint32_t>(std::countr_zero(mask)));
}

}  // namespace warpgrain::profiler::sass
