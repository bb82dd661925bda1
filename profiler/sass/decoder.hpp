#pragma once
// Machine code -> instructions.

#include <string_view>
#include <vector>

#include "profiler/sass/instruction.hpp"

namespace warpgrain::profiler::sass {

// One instruction each 16 bytes, without the padding at the end (`NOP`s behind a branch to itself), of code
// for architecture sm_`sm`. Lines are left 0.
std::vector<Instruction> decode(std::string_view code, unsigned sm);

}  // namespace warpgrain::profiler::sass
