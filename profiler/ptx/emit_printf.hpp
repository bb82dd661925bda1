#pragma once
// Calls of printf, which have no body in PTX: clang's with the arguments one by one, CUDA's vprintf with
// their place.

#include <string_view>

#include "profiler/ptx/emitter.hpp"

namespace warpgrain::profiler::ptx {

bool is_printf(std::string_view callee);

// The call at hand: `(result), printf, (format, ...)` or `(result), vprintf, (format, packed)`.
void emit_printf(Emitter& emitter);

}  // namespace warpgrain::profiler::ptx
