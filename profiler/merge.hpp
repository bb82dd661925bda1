#pragma once
// Puts the lanes of a warp together again: from the blocks that each lane ran alone, the blocks that the warp
// issues and for which lanes.

#include <cstdint>
#include <memory>
#include <span>

#include "profiler/kernel_graph.hpp"
#include "profiler/merge_policy.hpp"
#include "profiler/observers/warp_counters.hpp"
#include "profiler/observers/warp_observer.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler {

inline constexpr std::uint32_t min_warp_width = 4, max_warp_width = 64;

// Merges warp by warp. Holds scratch space, so one for each thread.
class WarpMerger {
 public:
  virtual ~WarpMerger() = default;
  // `lanes` are the warp's, [1 to warp_width]; a short span and null traces stand for lanes that do not
  // exist.
  virtual void merge(std::span<const LaneTrace> lanes) = 0;
};

// Throws InputError for what is no width.
void check_warp_width(std::uint32_t width);

// Merges the lanes of a work-group, `width` at a time.
void merge_warps(WarpMerger& merger, std::span<const LaneTrace> lanes, std::uint32_t width);

// The plain way: any policy, every event reported to `observer`, and a trace that does not fit the graph is a
// std::logic_error. `graph` and `observer` outlive the merger.
std::unique_ptr<WarpMerger> make_observed_merger(const KernelGraph& graph, MergePolicy policy,
                                                 std::uint32_t warp_width, WarpObserver& observer);

// The fast way to the same sums: adds to `counters`, which was made for the graph and the warp width, and
// trusts the traces. `graph` and `counters` outlive the merger.
std::unique_ptr<WarpMerger> make_counting_merger(const KernelGraph& graph, MergePolicy policy,
                                                 WarpCounters& counters);

}  // namespace warpgrain::profiler
