#pragma once
// What each conditional branch did to its warps.

#include <vector>

#include "profiler/counters.hpp"
#include "profiler/kernel_graph.hpp"
#include "profiler/observers/warp_counters.hpp"
#include "profiler/source_lines.hpp"

namespace warpgrain::profiler {

// The branches that were executed, by lane slots lost, the most first, then by block. A branch without a
// source line has the PTX instruction for its label.
std::vector<BranchTotals> branch_totals(const KernelGraph& graph, const WarpCounters& counters,
                                        const SourceLines& source);

}  // namespace warpgrain::profiler
