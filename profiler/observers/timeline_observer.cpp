#include "profiler/observers/timeline_observer.hpp"

#include <bit>

namespace warpgrain::profiler {

void TimelineObserver::warp_begins(std::uint64_t) { timeline_ = {}; }

void TimelineObserver::block_issued(const LaneGroup& group, std::span<const std::uint64_t* const>) {
  const std::uint64_t instructions = graph_.blocks[group.block].instructions.size();
  timeline_.sums.warp_instructions += instructions;
  timeline_.sums.thread_instructions += instructions * static_cast<std::uint64_t>(std::popcount(group.lanes));
  if (++timeline_.executions > max_executions_) return;
  timeline_.blocks.push_back(group.block);
  timeline_.lanes.push_back(group.lanes);
}

}  // namespace warpgrain::profiler
