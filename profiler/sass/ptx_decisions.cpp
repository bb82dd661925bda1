#include "profiler/sass/ptx_decisions.hpp"

#include "profiler/control_flow.hpp"

namespace warpgrain::profiler::sass {

PtxDecisions::PtxDecisions(const KernelGraph& graph)
    : graph_(graph),
      at_end_(graph.blocks.size(), no_decision),
      way_end_(graph.blocks.size(), no_block),
      decided_by_(graph.blocks.size(), no_block) {
  std::unordered_map<std::uint32_t, std::uint32_t> by_line;
  std::vector<std::vector<std::uint32_t>> predecessors(graph.blocks.size());
  for (std::uint32_t b = 0; b < graph.blocks.size(); ++b) {
    const BasicBlock& block = graph.blocks[b];
    for (std::uint32_t i = 0; i < block.instructions.size(); ++i)
      places_[block.instructions[i].ptx_line].push_back({b, i});
    for (const std::uint32_t to : block.successors) predecessors[to].push_back(b);
    if (block.successors.size() < 2) continue;
    const auto [found, is_new] =
        by_line.try_emplace(block.instructions.back().ptx_line, static_cast<std::uint32_t>(blocks_.size()));
    if (is_new) blocks_.emplace_back();
    blocks_[found->second].push_back(b);
    at_end_[b] = found->second;
  }
  for (std::uint32_t b = 0; b < graph.blocks.size(); ++b) {
    std::uint32_t at = b;
    for (std::size_t steps = 0; steps < graph.blocks.size() && graph.blocks[at].successors.size() == 1;
         ++steps)
      at = graph.blocks[at].successors[0];
    if (at_end_[at] != no_decision) way_end_[b] = at;
    at = b;
    for (std::size_t steps = 0; steps < graph.blocks.size() && predecessors[at].size() == 1; ++steps) {
      at = predecessors[at][0];
      if (at_end_[at] == no_decision) continue;
      decided_by_[b] = at;
      break;
    }
  }
}

const std::vector<PtxPlace>& PtxDecisions::places(std::uint32_t line) const {
  static const std::vector<PtxPlace> none;
  const auto found = places_.find(line);
  return found == places_.end() ? none : found->second;
}

}  // namespace warpgrain::profiler::sass
