#pragma once
// NVIDIA's assembler, where it is installed: PTX -> machine code. It needs no GPU.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace warpgrain::profiler::sass {

struct Ptxas {
  std::filesystem::path program;
  std::string version;  // "13.0.88", as it says itself
};

// The one in PATH, else of CUDA_HOME or CUDA_PATH, else (where neither is set) of /usr/local/cuda.
std::optional<Ptxas> find_ptxas();

enum class LineTable : bool { without, with };

// The cubin that the assembler makes for `arch`, "sm_90". Throws InputError with what it says where it takes
// the text not.
std::string assemble(const Ptxas& ptxas, std::string_view ptx, std::string_view arch, LineTable lines);

}  // namespace warpgrain::profiler::sass
