#pragma once
// The counters of a launch from its replay.

#include "profiler/counters.hpp"
#include "profiler/sass/machine_kernel.hpp"
#include "profiler/sass/replay_counters.hpp"
#include "profiler/source_lines.hpp"

namespace warpgrain::profiler::sass {

// Puts the instructions of the machine code in the place of those of the PTX: totals, lines and branches.
// Requests to memory stay as the merged lanes made them.
void put_replay(const MachineKernel& kernel, const ReplayCounters& counters, const SourceLines& source,
                LaunchCounters& launch);

}  // namespace warpgrain::profiler::sass
