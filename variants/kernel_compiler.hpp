#pragma once
// Who makes PTX of the kernels. The text is one: prelude_opencl.h and prelude_cuda.h give it the words of
// either dialect.

#include <cstdint>
#include <string>
#include <string_view>

namespace warpgrain {

namespace profiler {
struct CompiledPtx;
}
struct SourceUnit;

enum class KernelCompiler : std::uint8_t {
  clang,  // as OpenCL C, by clang: what the simulator runs elsewhere
  cuda,   // as CUDA C++, by nvcc, or by NVRTC where there is no nvcc
  nvidia  // as OpenCL C, by the compiler in NVIDIA's OpenCL driver, which needs its GPU
};
// Throws InputError that lists the valid names.
KernelCompiler kernel_compiler(std::string_view name, std::string_view where);

// OpenCL C's build options in nvcc's words: -D as they are, accuracy of divisions and roots by -prec-div,
// -prec-sqrt and -use_fast_math. Throws InputError for an option that has none.
std::string cuda_build_options(std::string_view opencl_options);

// Needs the simulator's front ends. Throws InputError with the compiler's message, or with what is missing.
profiler::CompiledPtx compile_unit(const SourceUnit& unit, KernelCompiler compiler);

}  // namespace warpgrain
