#pragma once
// The counters of a launch from its replay.

#include "profiler/counters.hpp"
#include "profiler/observers/warp_counters.hpp"
#include "profiler/sass/machine_kernel.hpp"
#include "profiler/sass/replay_counters.hpp"
#include "profiler/source_lines.hpp"

namespace warpgrain::profiler::sass {

// Puts the instructions and requests of the machine code in the place of those of the PTX: totals, lines and
// branches. Requests that could not be followed stay as the merged lanes made them, and are counted.
void put_replay(const MachineKernel& kernel, const ReplayCounters& counters, const WarpCounters& of_ptx,
                const SourceLines& source, LaunchCounters& launch);

}  // namespace warpgrain::profiler::sass
