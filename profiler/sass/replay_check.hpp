#pragma once
// Holds a replay against the trace: what has an effect outside its lane happens as often in both.

#include <cstdint>
#include <string>
#include <vector>

#include "profiler/observers/warp_counters.hpp"
#include "profiler/sass/machine_kernel.hpp"
#include "profiler/sass/replay_counters.hpp"

namespace warpgrain::profiler::sass {

// Stores, atomic operations and barriers of the PTX that the machine code's lanes ran more or less often than
// the trace's, a line each. The assembler may not drop, repeat or invent them; those under a predicate, or
// joined with a neighbour, are not judged.
std::vector<std::string> contradictions(const MachineKernel& kernel, const ReplayCounters& counters,
                                        const WarpCounters& of_ptx);

}  // namespace warpgrain::profiler::sass
