#pragma once
// From the recorded blocks of a trace to all the blocks that the lane ran.

#include <cstdint>
#include <vector>

#include "profiler/kernel_graph.hpp"

namespace warpgrain::profiler {

// For each recorded block the blocks that a lane runs from it to the next recorded one or its end: itself,
// and those that follow as only successors. Empty for blocks that are not recorded. [n_blocks]
std::vector<std::vector<std::uint32_t>> block_runs(const KernelGraph& graph);

}  // namespace warpgrain::profiler
