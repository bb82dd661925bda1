#include "profiler/reconvergence.hpp"

#include "profiler/control_flow.hpp"

namespace warpgrain::profiler {
namespace {

// Marks the joins of one loop level.
void mark_joins(const KernelGraph& graph, const std::vector<std::uint32_t>& post_dominator,
                std::vector<bool>& join) {
  for (std::size_t block = 0; block < graph.blocks.size(); ++block) {
    const std::uint32_t meeting = post_dominator[block];
    if (graph.blocks[block].successors.size() > 1 && meeting != no_block) join[meeting] = true;
  }
}

}  // namespace

Reconvergence find_reconvergence(const KernelGraph& graph) {
  const ControlFlow flow(graph);
  Reconvergence result;
  result.rank.resize(graph.blocks.size());
  const std::vector<std::uint32_t> order = flow.loop_contiguous_order();
  for (std::uint32_t i = 0; i < order.size(); ++i) result.rank[order[i]] = i;
  result.join.resize(graph.blocks.size());
  result.immediate_post_dominator = flow.immediate_post_dominators(no_loop);
  mark_joins(graph, result.immediate_post_dominator, result.join);
  for (std::uint32_t loop = 0; loop < flow.loops().size(); ++loop) {
    result.join[flow.loops()[loop].header] = true;
    mark_joins(graph, flow.immediate_post_dominators(loop), result.join);
  }
  return result;
}

}  // namespace warpgrain::profiler
