#pragma once
// How many lanes of each instruction of the machine code have a true predicate.

#include <cstdint>
#include <vector>

#include "profiler/observers/warp_counters.hpp"
#include "profiler/sass/machine_kernel.hpp"
#include "profiler/sass/replay_counters.hpp"

namespace warpgrain::profiler::sass {

struct PredicatedLanes {
  std::vector<std::uint64_t> on;  // [instructions]: of all lanes that executed it
  std::uint64_t assumed = 0;      // lanes whose predicate nothing in the trace tells
};

// A guard tells its predicate. Instructions that the assembler has put under a predicate in place of a branch
// run in the lanes for which the trace has their block of the PTX. Of the others, the scaling of denormal and
// huge operands of special functions is taken to be off, what else there is to be on.
PredicatedLanes count_predicated(const MachineKernel& kernel, const ReplayCounters& counters,
                                 const WarpCounters& of_ptx);

}  // namespace warpgrain::profiler::sass
