#pragma once
// Arithmetic of half precision: opcodes that other types share, told apart by .f16 and .f16x2.

#include "profiler/ptx/instructions.hpp"

namespace warpgrain::profiler::ptx {

bool is_half_arithmetic(const Statement& statement);
const InstructionTable& half_instructions();

}  // namespace warpgrain::profiler::ptx
