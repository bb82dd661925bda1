#include "profiler/observers/blocks.hpp"

#include <algorithm>
#include <numeric>

namespace warpgrain::profiler {

std::vector<BlockTotals> block_totals(const KernelGraph& graph, const WarpCounters& counters) {
  std::vector<BlockTotals> result;
  for (std::uint32_t b = 0; b < graph.blocks.size(); ++b) {
    const auto executions = counters.executions(b);
    const auto& instructions = graph.blocks[b].instructions;
    const auto placed = std::ranges::find_if(
        instructions, [](const Instruction& instruction) { return instruction.location.line != 0; });
    result.push_back({b,
                      graph.blocks[b].label,
                      graph.blocks[b].instructions.size(),
                      std::accumulate(executions.begin(), executions.end(), std::uint64_t{0}),
                      counters.divergent[b],
                      {executions.begin(), executions.end()},
                      placed == instructions.end() ? "" : graph.files[placed->location.file],
                      placed == instructions.end() ? 0 : placed->location.line});
  }
  return result;
}

}  // namespace warpgrain::profiler
