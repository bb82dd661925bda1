#pragma once
// Where lanes that parted may come together again, and which of several groups of lanes runs first.

#include <cstdint>
#include <vector>

#include "profiler/kernel_graph.hpp"

namespace warpgrain::profiler {

// All vectors are [n_blocks], by block index.
struct Reconvergence {
  // Place of the block in the loop-contiguous reverse post-order; the group at the lowest one runs first.
  std::vector<std::uint32_t> rank;
  // Whether groups that meet at the block become one under `loop_postdom`. A block is a join when it is a
  // loop header, or when at some loop level it is the immediate post-dominator of a block with several
  // successors. At the level of a loop, leaving it does not count as a way on. This is where ptxas puts a
  // BSYNC: `break` and `continue` take lanes out of the loop's barrier (BREAK), and those that stay still
  // join at the end of the `if` inside.
  std::vector<bool> join;
  // Immediate post-dominator in the whole graph, no_block when that is the end of the kernel. Where `ipdom`
  // joins.
  std::vector<std::uint32_t> immediate_post_dominator;
};

Reconvergence find_reconvergence(const KernelGraph& graph);

}  // namespace warpgrain::profiler
