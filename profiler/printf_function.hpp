#pragma once
// printf of translated code.

#include <cstdint>

#include "profiler/lane_context.hpp"

namespace warpgrain::profiler {

// Appends to the lane's text. `arguments` [count] are the places of the arguments, `sizes` [count] their
// bytes; -1 when the launch keeps no text.
std::int32_t print_arguments(LaneContext* lane, const char* format, const std::byte* const* arguments,
                             const std::uint32_t* sizes, std::uint32_t count);

// CUDA's vprintf: the arguments lie in `packed`, each aligned to its size.
std::int32_t print_packed(LaneContext* lane, const char* format, const std::byte* packed);

}  // namespace warpgrain::profiler
