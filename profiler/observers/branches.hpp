#pragma once
// What each conditional branch did to its warps.

#include <cstdint>
#include <string>
#include <vector>

#include "profiler/counters.hpp"
#include "profiler/kernel_graph.hpp"
#include "profiler/observers/warp_counters.hpp"
#include "profiler/source_lines.hpp"

namespace warpgrain::profiler {

// The name of the branch at the end of a block: its source line's, or the PTX instruction where there is
// none.
std::string branch_label(const KernelGraph& graph, std::uint32_t block, const SourceLines& source);

// The branches that were executed, by lane slots lost, the most first, then by block.
std::vector<BranchTotals> branch_totals(const KernelGraph& graph, const WarpCounters& counters,
                                        const SourceLines& source);

}  // namespace warpgrain::profiler
