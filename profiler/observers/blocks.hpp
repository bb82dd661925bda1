#pragma once
// How often each PTX block was issued, and for how many lanes.

#include <vector>

#include "profiler/counters.hpp"
#include "profiler/kernel_graph.hpp"
#include "profiler/observers/warp_counters.hpp"

namespace warpgrain::profiler {

// Every block, in order.
std::vector<BlockTotals> block_totals(const KernelGraph& graph, const WarpCounters& counters);

}  // namespace warpgrain::profiler
