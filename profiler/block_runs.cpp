#include "profiler/block_runs.hpp"

namespace warpgrain::profiler {

std::vector<std::vector<std::uint32_t>> block_runs(const KernelGraph& graph) {
  std::vector<std::vector<std::uint32_t>> runs(graph.blocks.size());
  for (std::uint32_t first = 0; first < graph.blocks.size(); ++first) {
    if (!graph.blocks[first].recorded) continue;
    runs[first].push_back(first);
    // A cycle of unrecorded blocks is a loop that nothing leaves: no trace that has an end goes into it.
    while (runs[first].size() <= graph.blocks.size()) {
      const std::vector<std::uint32_t>& next = graph.blocks[runs[first].back()].successors;
      if (next.size() != 1 || graph.blocks[next[0]].recorded) break;
      runs[first].push_back(next[0]);
    }
  }
  return runs;
}

}  // namespace warpgrain::profiler
