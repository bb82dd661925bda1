#include "profiler/sass/replay_check.hpp"

#include <fmt/format.h>
#include <map>

namespace warpgrain::profiler::sass {
namespace {

bool has_effect(InstructionClass c) {
  switch (c) {
    case InstructionClass::global_store:
    case InstructionClass::generic_store:
    case InstructionClass::shared_store:
    case InstructionClass::atomic:
    case InstructionClass::barrier:
      return true;
    default:
      return false;
  }
}

std::uint64_t lanes_of(std::span<const std::uint64_t> executions) {
  std::uint64_t lanes = 0;
  for (std::size_t n = 0; n < executions.size(); ++n) lanes += executions[n] * n;
  return lanes;
}

struct Count {
  std::uint64_t lanes = 0;
  bool judged = true;
};

// By line of the PTX. Of an instruction that takes several of the machine's, the first of each block speaks.
std::map<std::uint32_t, Count> counts_in_code(const MachineKernel& kernel, const ReplayCounters& counters) {
  std::map<std::uint32_t, Count> counts;
  for (std::uint32_t b = 0; b < kernel.code.blocks.size(); ++b)
    for (std::uint32_t k = kernel.code.blocks[b].first; k < kernel.code.blocks[b].last; ++k) {
      const Instruction& instruction = kernel.code.instructions[k];
      if (!has_effect(instruction.instruction_class)) continue;
      Count& count = counts[instruction.line];
      count.lanes += lanes_of(counters.executions(b));
      if (instruction.is_conditional()) count.judged = false;
    }
  return counts;
}

}  // namespace

std::vector<std::string> contradictions(const MachineKernel& kernel, const ReplayCounters& counters,
                                        const WarpCounters& of_ptx) {
  const KernelGraph& graph = kernel.decisions.graph();
  std::vector<std::string> found;
  for (const auto& [line, count] : counts_in_code(kernel, counters)) {
    if (!count.judged) continue;
    std::uint64_t lanes = 0;
    const profiler::Instruction* instruction = nullptr;
    for (const PtxPlace& place : kernel.decisions.places(line)) {
      instruction = &graph.blocks[place.block].instructions[place.instruction];
      lanes += lanes_of(of_ptx.executions(place.block));
    }
    if (instruction == nullptr || !has_effect(instruction->instruction_class) || lanes == count.lanes)
      continue;
    found.push_back(fmt::format("PTX line {}, '{}': {} lanes, in the machine code {}", line,
                                instruction->text, lanes, count.lanes));
  }
  return found;
}

}  // namespace warpgrain::profiler::sass
