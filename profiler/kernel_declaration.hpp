#pragma once
// The parameters that clang notes with -cl-kernel-arg-info.

#include <string_view>
#include <vector>

#include "profiler/opencl_frontend.hpp"

namespace warpgrain::profiler {

// Of a kernel in LLVM bitcode; none when there is no such kernel. Throws std::runtime_error for bytes that
// are no bitcode of this LLVM.
std::vector<ParameterDeclaration> parameters_in_bitcode(std::string_view bitcode, std::string_view kernel);

}  // namespace warpgrain::profiler
