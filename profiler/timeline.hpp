#pragma once
// What single warps did, block by block: which are followed, and what is kept of them.

#include <cstdint>
#include <string>
#include <vector>

namespace warpgrain::profiler {

struct WarpSums {
  std::uint64_t warp_instructions = 0;  // of the PTX; 0: there is no such warp
  std::uint64_t thread_instructions = 0;
  bool operator==(const WarpSums&) const = default;
};

struct TimelineOptions {
  // By SIMT efficiency: of 32 warps that lie evenly in the launch the one nearest to the median of all; the
  // lowest of all.
  bool median = false, worst = false;
  bool costliest = false;               // the warp that left the most lane slots idle
  std::vector<std::uint64_t> warps;     // by number; those that a launch has not are left out
  std::uint64_t max_executions = 2048;  // of blocks: how much is kept of a warp
  bool any() const { return median || worst || costliest || !warps.empty(); }
};

// Warps are numbered as launched: work-group by work-group, each of local size / warp width, rounded up.
struct WarpTimeline {
  std::uint64_t warp = 0;
  std::vector<std::string> chosen_as;  // "median", "worst", "costliest", "number"
  WarpSums sums;                       // of all of it
  std::uint64_t executions = 0;        // of blocks; more than are in `blocks`: the rest was cut off
  std::vector<std::uint32_t> blocks;   // in the order of issuing: index into LaunchCounters::blocks
  std::vector<std::uint64_t> lanes;    // [blocks.size()]: the active ones, a bit each
  bool operator==(const WarpTimeline&) const = default;
};

}  // namespace warpgrain::profiler
