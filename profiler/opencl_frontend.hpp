#pragma once
// OpenCL C -> PTX, with line numbers, through clang's NVPTX target and libclc.

#include <string>
#include <string_view>

namespace warpgrain::profiler {

struct CompiledPtx {
  std::string ptx;
  std::string compiler;  // version line of the clang that was used
  std::string command;   // its options, the pinned pass pipeline among them; part of the report's provenance
};

// Compiles OpenCL C 1.2 text. `source_name` is the file that lines are counted in until a #line says
// otherwise; `build_options` are the user's, as for clBuildProgram. Throws InputError with clang's own
// message (file and line), or with what is missing when there is no clang 15 or no libclc.
CompiledPtx compile_opencl(std::string_view source, std::string_view source_name,
                           std::string_view build_options = {});

}  // namespace warpgrain::profiler
