#pragma once
// The sums over warps from which every counter of a launch follows. Whole numbers, kept per block of the
// kernel, so that counting costs little while lanes are merged and the sums do not depend on the order of the
// warps.

#include <cstdint>
#include <span>
#include <vector>

#include "profiler/counters.hpp"
#include "profiler/kernel_graph.hpp"
#include "profiler/observers/warp_observer.hpp"

namespace warpgrain::profiler {

struct WarpCounters {
  WarpCounters(const KernelGraph& graph, std::uint32_t warp_width);

  // Adds sums of the same kernel and width.
  void add(const WarpCounters& other);

  std::span<std::uint64_t> executions(std::uint32_t block) {  // by number of active lanes, [warp_width + 1]
    return {block_executions.data() + std::size_t{block} * (warp_width + 1), warp_width + 1};
  }
  std::span<const std::uint64_t> executions(std::uint32_t block) const {
    return {block_executions.data() + std::size_t{block} * (warp_width + 1), warp_width + 1};
  }
  // The branch number under which lane slots count that no branch lost.
  std::uint32_t never_used() const { return static_cast<std::uint32_t>(lane_slots_lost.size() - 1); }

  std::uint32_t warp_width;
  std::uint64_t warps = 0;
  WarpSums issued;                              // by all of them
  std::vector<std::uint64_t> block_executions;  // [n_blocks][warp_width + 1]
  std::vector<std::uint64_t> divergent;         // [n_blocks]: executions whose lanes went different ways
  std::vector<std::uint64_t> taken_lanes;  // [n_blocks]: lanes that went to the first of several successors
  std::vector<std::uint64_t> lane_slots_lost;  // [n_blocks + 1], by the branch at the end of the block
  std::vector<std::uint32_t> first_access;  // [n_blocks]: where the accesses of the block begin in the next
  std::vector<MemoryCounters> accesses;     // one for each BasicBlock::accesses
};

// Counts a request of lanes that touch `addresses`, `bytes` each; none is no request.
void count_request(MemoryCounters& counters, std::span<const std::uint64_t> addresses, std::uint32_t bytes);

// Sums the events of warps.
class WarpCounterObserver : public WarpObserver {
 public:
  WarpCounterObserver(const KernelGraph& graph, WarpCounters& counters)
      : graph_(graph), counters_(counters) {}
  void warp_begins(std::uint64_t lanes) override;
  void block_issued(const LaneGroup& group, std::span<const std::uint64_t* const> addresses) override;
  void branch_executed(const LaneGroup& group, std::uint64_t taken,
                       std::span<const LaneGroup> parts) override;
  void lanes_idled(const LaneGroup& group, std::uint32_t branch, std::uint64_t idle) override;

 private:
  const KernelGraph& graph_;
  WarpCounters& counters_;
};

}  // namespace warpgrain::profiler
