#pragma once
// The totals of each source line.

#include <vector>

#include "profiler/counters.hpp"
#include "profiler/kernel_graph.hpp"
#include "profiler/observers/warp_counters.hpp"

namespace warpgrain::profiler {

// Lines whose instructions were issued at least once, sorted by file and line.
std::vector<LineTotals> line_totals(const KernelGraph& graph, const WarpCounters& counters);

}  // namespace warpgrain::profiler
