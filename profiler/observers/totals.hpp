#pragma once
// The totals of a launch, and what one instruction adds to them.

#include <cstdint>

#include "profiler/counters.hpp"
#include "profiler/kernel_graph.hpp"
#include "profiler/observers/warp_counters.hpp"

namespace warpgrain::profiler {

// All zero, with a lane histogram for the width.
Totals empty_totals(std::uint32_t warp_width);

// Where the conditional branch at the end of a block stands: an index into BasicBlock::instructions.
std::uint32_t branch_instruction(const BasicBlock& block);

// Adds all that counts to one instruction: how often it was issued, its branch, its memory requests.
void add_instruction(const KernelGraph& graph, const WarpCounters& counters, std::uint32_t block,
                     std::uint32_t instruction, Totals& totals);

Totals launch_totals(const KernelGraph& graph, const WarpCounters& counters);

}  // namespace warpgrain::profiler
