#pragma once
// What instructions on the special-function units (SFU) cost a machine that has fewer of these than lanes.
//
//   cycles        = sfu_instructions * warp_width / sfu_lanes     that the units of a multiprocessor are busy
//   issue_cycles  = warp_instructions / issue_rate                that its schedulers are busy
//   serialisation = (warp_width / sfu_lanes) / (warp_width / lanes) = lanes / sfu_lanes
//
// A warp instruction on four units passes in eight cycles where one of 32-bit arithmetic on 32 lanes passes
// in one: serialisation 8, as Washizawa and Nakahara (2013) put it for the Tesla C2050. cycles / issue_cycles
// is how full the units are if nothing else holds the warps up; above 1 they are the limit. Cycles are summed
// over multiprocessors, all instructions counted together: divided by multiprocessors and clock they are a
// time. Conversions count among sfu_instructions, as Nsight Compute's xu pipe does; machines convert at rates
// of their own.

#include <cstdint>

#include "analysis/machine.hpp"
#include "profiler/counters.hpp"

namespace warpgrain {

struct SfuCost {
  std::uint64_t instructions = 0;  // warp instructions
  double serialisation = 1;
  double cycles = 0;
  double issue_cycles = 0;

  double share() const { return issue_cycles == 0 ? 0 : cycles / issue_cycles; }
};

// `totals` were counted with `warp_width` lanes.
SfuCost sfu_cost(const profiler::Totals& totals, std::uint32_t warp_width, const Machine& machine);

}  // namespace warpgrain
