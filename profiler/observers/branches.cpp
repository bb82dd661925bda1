#include "profiler/observers/branches.hpp"

#include <algorithm>

#include "profiler/observers/totals.hpp"

namespace warpgrain::profiler {

std::string branch_label(const KernelGraph& graph, std::uint32_t block, const SourceLines& source) {
  const BasicBlock& of_branch = graph.blocks[block];
  const Instruction& instruction = of_branch.instructions[branch_instruction(of_branch)];
  const SourceLocation location = instruction.location;
  std::string label =
      location.line == 0 ? source.label("", 0) : source.label(graph.files[location.file], location.line);
  return label.empty() ? instruction.text : label;
}

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
    const SourceLocation location = block.instructions[branch_instruction(block)].location;
    if (location.line != 0) {
      branch.file = graph.files[location.file];
      branch.line = location.line;
    }
    branch.label = branch_label(graph, b, source);
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
