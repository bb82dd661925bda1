#include "profiler/observers/branches.hpp"

#include <algorithm>

#include "profiler/observers/totals.hpp"

namespace warpgrain::profiler {

std::vector<BranchTotals> branch_totals(const KernelGraph& graph, const WarpCounters& counters,
                                        const SourceLines& source) {
  std::vector<BranchTotals> result;
  for (std::uint32_t b = 0; b < graph.blocks.size(); ++b) {
    const BasicBlock& block = graph.blocks[b];
    if (block.successors.size() < 2) continue;
    BranchTotals branch;
    const auto executions = counters.executions(b);
    for (std::size_t lanes = 0; lanes < executions.size(); ++lanes) {
      branch.executions += executions[lanes];
      branch.lanes += executions[lanes] * lanes;
    }
    if (branch.executions == 0) continue;
    const Instruction& instruction = block.instructions[branch_instruction(block)];
    if (instruction.location.line != 0) {
      branch.file = graph.files[instruction.location.file];
      branch.line = instruction.location.line;
    }
    branch.label = source.label(branch.file, branch.line);
    if (branch.label.empty()) branch.label = instruction.text;
    branch.block = b;
    branch.divergent = counters.divergent[b];
    branch.taken_lanes = counters.taken_lanes[b];
    branch.lane_slots_lost = counters.lane_slots_lost[b];
    result.push_back(std::move(branch));
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return a.lane_slots_lost > b.lane_slots_lost; });
  return result;
}

}  // namespace warpgrain::profiler
