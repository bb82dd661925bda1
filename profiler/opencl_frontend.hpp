#pragma once
// OpenCL C -> PTX, with line numbers, through clang's NVPTX target and libclc.

#include <string>
#include <string_view>
#include <vector>

namespace warpgrain::profiler {

struct CompiledPtx {
  std::string ptx;
  std::string compiler;  // version line of the clang that was used
  std::string command;   // its options, the pinned pass pipeline among them; part of the report's provenance
};

// Stands in the PTX of a program that was compiled for launches whose last work-groups are smaller: its sizes
// of index spaces are the simulator's to give, and no device's.
inline constexpr std::string_view smaller_groups_mark = "// smaller last work-groups";

// The build option that asks for it.
inline constexpr std::string_view smaller_groups_option = "-DWARPGRAIN_SMALLER_GROUPS";

// Compiles OpenCL C 1.2 text. `source_name` is the file that lines are counted in until a #line says
// otherwise; `build_options` are the user's, as for clBuildProgram. Throws InputError with clang's own
// message (file and line), or with what is missing when there is no clang 15 or no libclc.
CompiledPtx compile_opencl(std::string_view source, std::string_view source_name,
                           std::string_view build_options = {});

// A parameter as the kernel's source declares it.
struct ParameterDeclaration {
  std::string name;
  std::string type;  // without address space, type names resolved: "float4*", "int"
};

// The same text as LLVM bitcode that keeps the parameters' names and types, for parameters_in_bitcode.
std::string declaration_bitcode(std::string_view source, std::string_view source_name,
                                std::string_view build_options);

// The parameters of a kernel of the same text; none when there is no such kernel. PTX keeps neither names nor
// types.
std::vector<ParameterDeclaration> declared_parameters(std::string_view source, std::string_view source_name,
                                                      std::string_view build_options,
                                                      std::string_view kernel);

}  // namespace warpgrain::profiler
