#pragma once
// The built-in functions of profiler/builtins as LLVM bitcode for NVPTX, made by clang when the program was
// built.

#include <string_view>

namespace warpgrain::profiler {

std::string_view embedded_builtins();

}  // namespace warpgrain::profiler
