#include "profiler/observers/totals.hpp"

#include <span>

namespace warpgrain::profiler {
namespace {

// Where accesses of a class are counted; null for those that are not recorded.
MemoryCounters* counters_of(Totals& totals, InstructionClass access) {
  switch (access) {
    case InstructionClass::global_load:
    case InstructionClass::generic_load:
      return &totals.global_load;
    case InstructionClass::global_store:
    case InstructionClass::generic_store:
      return &totals.global_store;
    case InstructionClass::shared_load:
      return &totals.shared_load;
    case InstructionClass::shared_store:
      return &totals.shared_store;
    case InstructionClass::atomic:
      return &totals.atomic;
    default:
      return nullptr;
  }
}

}  // namespace

Totals empty_totals(std::uint32_t warp_width) {
  Totals totals;
  totals.lane_histogram.resize(warp_width + 1);
  return totals;
}

std::uint32_t branch_instruction(const BasicBlock& block) {
  const auto n = static_cast<std::uint32_t>(block.instructions.size());
  for (std::uint32_t i = n; i-- > 0;)
    if (block.instructions[i].instruction_class == InstructionClass::branch) return i;
  return n - 1;
}

void add_instruction(const KernelGraph& graph, const WarpCounters& counters, std::uint32_t b, std::uint32_t i,
                     Totals& totals) {
  const BasicBlock& block = graph.blocks[b];
  const Instruction& instruction = block.instructions[i];
  const std::span<const std::uint64_t> executions = counters.executions(b);
  std::uint64_t warps = 0, threads = 0;
  for (std::size_t lanes = 0; lanes < executions.size(); ++lanes) {
    warps += executions[lanes];
    threads += executions[lanes] * lanes;
    totals.lane_histogram[lanes] += executions[lanes];
  }
  totals.warp_instructions += warps;
  totals.thread_instructions += threads;
  totals.sfu_instructions += warps * instruction.sfu_operations;
  InstructionCount& mix = totals.instruction_mix[static_cast<std::size_t>(instruction.instruction_class)];
  mix.warp += warps;
  mix.thread += threads;
  if (block.successors.size() > 1 && i == branch_instruction(block)) {
    totals.branches += warps;
    totals.divergent_branches += counters.divergent[b];
  }
  for (std::size_t k = 0; k < block.accesses.size(); ++k) {
    if (block.accesses[k].instruction != i) continue;
    if (MemoryCounters* memory = counters_of(totals, block.accesses[k].access))
      memory->add(counters.accesses[counters.first_access[b] + k]);
  }
}

Totals launch_totals(const KernelGraph& graph, const WarpCounters& counters) {
  Totals totals = empty_totals(counters.warp_width);
  for (std::uint32_t b = 0; b < graph.blocks.size(); ++b)
    for (std::uint32_t i = 0; i < graph.blocks[b].instructions.size(); ++i)
      add_instruction(graph, counters, b, i, totals);
  return totals;
}

}  // namespace warpgrain::profiler
