#pragma once
// Writes down what a warp issues.

#include "profiler/kernel_graph.hpp"
#include "profiler/observers/warp_observer.hpp"
#include "profiler/timeline.hpp"

namespace warpgrain::profiler {

class TimelineObserver : public WarpObserver {
 public:
  TimelineObserver(const KernelGraph& graph, std::uint64_t max_executions)
      : graph_(graph), max_executions_(max_executions) {}
  void warp_begins(std::uint64_t lanes) override;
  void block_issued(const LaneGroup& group, std::span<const std::uint64_t* const> addresses) override;

  // Of the last warp; its number and why it was chosen are for the caller.
  const WarpTimeline& timeline() const { return timeline_; }

 private:
  const KernelGraph& graph_;
  std::uint64_t max_executions_;
  WarpTimeline timeline_;
};

}  // namespace warpgrain::profiler
