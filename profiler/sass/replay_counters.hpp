#pragma once
// The sums over warps of a replay, from which a launch's totals follow.

#include <cstdint>
#include <span>
#include <vector>

#include "profiler/sass/replay_plan.hpp"
#include "profiler/sass/request_counter.hpp"

namespace warpgrain::profiler::sass {

inline constexpr std::uint32_t replayed_warp_width = 32;

struct ReplayCounters {
  ReplayCounters(const CodeGraph& code, const ReplayPlan& plan, const KernelGraph& graph);

  void add(const ReplayCounters& other);  // of the same plan

  std::span<const std::uint64_t> executions(std::uint32_t block) const {
    return {block_executions.data() + std::size_t{block} * (replayed_warp_width + 1),
            replayed_warp_width + 1};
  }
  std::span<const std::uint64_t> again(std::uint32_t block) const {
    return {issued_again.data() + std::size_t{block} * (replayed_warp_width + 1), replayed_warp_width + 1};
  }
  // The number under which lane slots count of lanes that do not exist.
  std::uint32_t never_used() const { return static_cast<std::uint32_t>(lane_slots_lost.size() - 1); }
  // Decisions that could not be derived: of lanes at guards, of lanes whose trace did not fit, of warps that
  // would have waited for ever.
  std::uint64_t unresolved() const;

  std::uint64_t warps = 0;
  std::vector<std::uint64_t> block_executions;  // [blocks of the code][warp_width + 1], by active lanes
  // The same of indirect branches that are issued again for the lanes that are left after each way.
  std::vector<std::uint64_t> issued_again;
  std::vector<std::uint64_t> divergent;    // [blocks of the code]: executions whose lanes went different ways
  std::vector<std::uint64_t> taken_lanes;  // [blocks of the code]: lanes that took the guard
  std::vector<std::uint64_t> lane_slots_lost;  // [blocks of the PTX + 1], by the decision at the block's end
  std::vector<std::uint64_t> underived;        // [nodes]: choices of lanes that could not be derived
  std::uint64_t out_of_step = 0;               // lanes whose trace and way through the code do not fit
  std::uint64_t stuck = 0;                     // meetings that lanes were expected at that could not come
  RequestCounters requests;
  std::uint64_t turns_assumed = 0;  // groups chosen by the rule of YIELD, which is known in part
  std::uint64_t trips_assumed = 0;  // ways that lanes took though their trips fit the other, too
  std::uint64_t fast_paths = 0;  // choices of lanes that were taken not to need a routine for rare operands
};

}  // namespace warpgrain::profiler::sass
