#pragma once
// The least time that counted instructions take a machine, whatever hides behind what:
//
//   issue  = warp_instructions / (issue_rate * multiprocessors * clock)
//   sfu    = sfu_instructions * warp_width / (sfu_lanes * multiprocessors * clock)
//   least  = max(issue, sfu)
//
// Waiting for memory and for each other comes on top, so a device takes longer. Bytes from memory are not in
// it: caches serve part of the sectors that warps ask for, and they are not modelled.

#include <cstdint>

#include "analysis/machine.hpp"
#include "profiler/counters.hpp"

namespace warpgrain {

struct LeastTime {
  double issue = 0, sfu = 0;  // s
  double seconds() const { return issue > sfu ? issue : sfu; }
};

// `totals` were counted with `warp_width` lanes.
LeastTime least_time(const profiler::Totals& totals, std::uint32_t warp_width, const Machine& machine);

}  // namespace warpgrain
