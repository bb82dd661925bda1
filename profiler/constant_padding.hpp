#pragma once
// A mend of clang 15's code for NVPTX: initial values of 3-vectors in arrays and structs.

#include <optional>
#include <string>
#include <string_view>

namespace warpgrain::profiler {

// A 3-vector takes the room of four (OpenCL C 1.2, 6.1.5), and addresses are computed so; but LLVM 15's NVPTX
// printer writes the initial value of one without its padding, so that all that follows in the variable
// stands too early. Gives the module with 4-vectors in the place of such values, which changes no address;
// nothing when there are none. Throws std::runtime_error for bytes that are no bitcode of this LLVM.
std::optional<std::string> pad_vectors_of_three(std::string_view bitcode);

}  // namespace warpgrain::profiler
