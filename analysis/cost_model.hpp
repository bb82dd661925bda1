#pragma once
// The time that a launch takes a machine, predicted from what the simulator counted. Clocks of one of S
// multiprocessors; the launch's work is taken to be spread over them evenly:
//
//   issue    = warp_instructions / issue_rate / S
//   sfu      = sfu_instructions * warp_width / sfu_lanes / S
//   lines    = line * (lines of load and store requests) / S
//   memory   = (far_sector * group_load + memory_sector * miss * launch_load
//               + store_sector * (1 + miss) * full + part_store_sector * part
//               + memory_part_sector * miss * launch_store * part / (full + part)
//               + atomic_sector * atomics) / S
//   latency  = (instruction * warp_instructions + load * requests + far_load * min(loads, group_load))
//              / S / resident warps
//   clocks   = (issue^p + sfu^p + lines^p + memory^p + latency^p)^(1/p),  p = overlap
//   seconds  = launch + (group_start * work_groups / S + clocks) / clock
//
// group_load are the distinct sectors that each work-group loads: the first cache serves the rest.
// launch_load and launch_store are distinct over the launch. `full` and `part` are the sectors that store
// requests write in full and in part, told apart by the bytes they store. miss is the share that the second
// cache has lost since it was last used:
//
//   miss = max(0, 1 - cached_bytes / working_set)
//
// It knows nothing of the order in which warps run, of banks, of the address translation, of what other warps
// of a multiprocessor leave in its cache, nor of warps that have more to do than others: docs/cost-model.md
// says how near it comes.

#include <cstdint>
#include <optional>

#include "analysis/machine.hpp"
#include "profiler/counters.hpp"

namespace warpgrain {

struct PredictedTime {
  double start = 0;  // s: the launch, and starting its work-groups
  double issue = 0, sfu = 0, lines = 0, memory = 0, latency = 0;  // s, each as if it were alone
  double seconds = 0;
  double resident_warps = 0;  // of a multiprocessor
};

enum class LaunchPlace : std::uint8_t {
  alone,  // as between two events
  next    // behind another launch
};

// `working_set`: bytes of memory that are touched in turn, this launch's among them. Nothing where the
// machine has no cost constants or the footprint was not counted.
std::optional<PredictedTime> predict_time(const profiler::LaunchCounters& launch, const Machine& machine,
                                          double working_set, LaunchPlace place);

// Warps that a multiprocessor holds at a time, where there are enough. Registers that are not known count as
// none.
double resident_warps(const profiler::LaunchCounters& launch, const CostConstants& cost,
                      double multiprocessors);

}  // namespace warpgrain
