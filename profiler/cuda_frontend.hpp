#pragma once
// CUDA C++ -> PTX, by nvcc (on PATH or in /usr/local/cuda/bin), or by NVRTC where there is no nvcc.

#include <filesystem>
#include <string>
#include <string_view>

#include "profiler/opencl_frontend.hpp"

namespace warpgrain::profiler {

// Compiles a .cu file for sm_80, unless `build_options` (nvcc's) name an architecture, with line numbers that
// name the file as `path` does. Throws InputError with the compiler's own message, or with what is missing
// when there is neither nvcc nor NVRTC.
CompiledPtx compile_cuda(const std::filesystem::path& path, std::string_view build_options);

}  // namespace warpgrain::profiler
