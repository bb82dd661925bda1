#pragma once
// The instructions that are carried, a table a family: opcode -> what emits it. Semantics: NVIDIA, "Parallel
// Thread Execution ISA", the chapter of the same name.

#include <string_view>
#include <unordered_map>

#include "profiler/ptx/emitter.hpp"

namespace warpgrain::profiler::ptx {

using InstructionEmitter = void (*)(Emitter&);
using InstructionTable = std::unordered_map<std::string_view, InstructionEmitter>;

const InstructionTable& arithmetic_instructions();  // add, mul, fma, div, min, ... of integers and floats
const InstructionTable& float_instructions();       // rcp, sqrt, sin, ...
const InstructionTable& bit_instructions();         // and, shl, bfe, popc, ...
const InstructionTable& compare_instructions();     // setp, selp, ...
const InstructionTable& move_instructions();        // mov, cvta
const InstructionTable& integer_instructions();     // dp4a, bmsk, szext, ...
const InstructionTable& convert_instructions();     // cvt
const InstructionTable& other_instructions();       // nanosleep, isspacep, hints
const InstructionTable& memory_instructions();      // ld, st, atom, red, fences
const InstructionTable& barrier_instructions();     // bar, barrier
const InstructionTable& warp_instructions();        // shfl, vote, match, ...

// What a kernel should be that has no such instruction, "a kernel without textures"; empty for an opcode that
// no version of PTX has.
std::string_view what_is_expected_instead(std::string_view opcode);

// Shared by the families.
llvm::Value* flush_subnormal(Emitter& emitter,
                             llvm::Value* value);  // .ftz of an f32: a subnormal becomes a signed zero
llvm::Value* saturate(Emitter& emitter, llvm::Value* value);  // .sat of a float: to [0, 1], NaN to 0

}  // namespace warpgrain::profiler::ptx
