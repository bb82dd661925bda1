#pragma once
// What a PTX instruction counts as.

#include "profiler/kernel_graph.hpp"
#include "profiler/ptx/module.hpp"

namespace warpgrain::profiler::ptx {

struct InstructionFacts {
  InstructionClass instruction_class = InstructionClass::other;
  std::uint8_t sfu_operations = 0;  // as Instruction::sfu_operations
  std::uint8_t accessed_bytes = 0;  // of one lane, for the accesses that a trace holds; else 0
  bool records_path = false;        // a trace holds its DivisionPath
};

InstructionFacts instruction_facts(const Statement& statement);

}  // namespace warpgrain::profiler::ptx
