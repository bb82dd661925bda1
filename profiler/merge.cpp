#include "profiler/merge.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "profiler/control_flow.hpp"

namespace warpgrain::profiler {
namespace {

// Lane by lane and block by block, with nothing cached: the reference for the fast merger.
class ObservedMerger : public WarpMerger {
 public:
  ObservedMerger(const KernelGraph& graph, MergePolicy policy, std::uint32_t warp_width,
                 WarpObserver& observer)
      : graph_(graph),
        schedule_(make_warp_schedule(policy, graph)),
        lanes_(warp_width),
        observer_(observer) {}

  void merge(std::span<const LaneTrace> traces) override {
    begin(traces);
    if (exist_ == 0) return;
    schedule_->start(exist_);
    observer_.warp_begins(exist_);
    while (const std::optional<LaneGroup> group = schedule_->next()) {
      for_each_lane(group->lanes, [&](std::uint32_t lane) { expect(lane, group->block); });
      report_idle(*group);
      issue(*group);
      const std::vector<LaneGroup> parts = step(*group);
      if (graph_.blocks[group->block].successors.size() > 1) part(*group, parts);
      schedule_->advance(parts);
    }
    for_each_lane(exist_, [&](std::uint32_t lane) { expect(lane, trace_end); });
  }

 private:
  struct Parting {
    std::uint64_t number = 0;  // counts partings in a warp; 0: the lane was never there
    std::uint32_t branch = no_block;
  };
  struct Lane {
    const BlockIndex* blocks = nullptr;
    const std::uint64_t* addresses = nullptr;
    std::uint32_t at = trace_end;                     // the block it runs next
    std::array<Parting, max_warp_width> parted_from;  // how each other lane went out of this one's group
  };

  template <typename Function>
  static void for_each_lane(std::uint64_t lanes, Function&& function) {
    for (; lanes != 0; lanes &= lanes - 1) function(static_cast<std::uint32_t>(std::countr_zero(lanes)));
  }

  void begin(std::span<const LaneTrace> traces) {
    exist_ = 0;
    n_partings_ = 0;
    for (std::uint32_t lane = 0; lane < traces.size(); ++lane) {
      lanes_[lane] = {traces[lane].blocks, traces[lane].addresses, trace_end, {}};
      if (lanes_[lane].blocks == nullptr) continue;
      exist_ |= std::uint64_t{1} << lane;
      lanes_[lane].at = *lanes_[lane].blocks++;
    }
  }

  void expect(std::uint32_t lane, std::uint32_t block) const {
    if (lanes_[lane].at != block)
      throw std::logic_error("lane " + std::to_string(lane) + " of a warp in kernel " + graph_.kernel +
                             " is at block " + std::to_string(lanes_[lane].at) + ", the warp at block " +
                             std::to_string(block));
  }

  void issue(const LaneGroup& group) {
    std::vector<const std::uint64_t*> addresses;
    const std::size_t n_accesses = graph_.blocks[group.block].accesses.size();
    for_each_lane(group.lanes, [&](std::uint32_t lane) {
      if (lanes_[lane].addresses == nullptr) return;
      addresses.push_back(lanes_[lane].addresses);
      lanes_[lane].addresses += n_accesses;
    });
    observer_.block_issued(group, addresses);
  }

  // Moves the lanes of the group on; where they are now, without those that ended.
  std::vector<LaneGroup> step(const LaneGroup& group) {
    const std::vector<std::uint32_t>& successors = graph_.blocks[group.block].successors;
    std::vector<LaneGroup> parts;
    for_each_lane(group.lanes, [&](std::uint32_t lane) {
      Lane& state = lanes_[lane];
      const bool recorded = successors.size() != 1 || graph_.blocks[successors[0]].recorded;
      state.at = recorded ? *state.blocks++ : successors[0];
      bool known = successors.empty() && state.at == trace_end;
      for (std::uint32_t successor : successors) known |= state.at == successor;
      if (!known)
        throw std::logic_error("a lane's trace goes from block " + std::to_string(group.block) +
                               " of kernel " + graph_.kernel + " to " + std::to_string(state.at) +
                               ", which does not follow it");
      if (state.at == trace_end) return;
      for (LaneGroup& part : parts)
        if (part.block == state.at) {
          part.lanes |= std::uint64_t{1} << lane;
          return;
        }
      parts.push_back({state.at, std::uint64_t{1} << lane});
    });
    return parts;
  }

  void part(const LaneGroup& group, const std::vector<LaneGroup>& parts) {
    std::uint64_t taken = 0;
    for (const LaneGroup& part : parts)
      if (part.block == graph_.blocks[group.block].successors[0]) taken = part.lanes;
    observer_.branch_executed(group, taken, parts);
    if (parts.size() < 2) return;
    ++n_partings_;
    for (const LaneGroup& part : parts)
      for_each_lane(part.lanes, [&](std::uint32_t lane) {
        for_each_lane(group.lanes & ~part.lanes, [&](std::uint32_t other) {
          lanes_[lane].parted_from[other] = {n_partings_, group.block};
        });
      });
  }

  // Of the partings of the group's lanes from an idle lane the latest counts, and from now on for all of the
  // group.
  void report_idle(const LaneGroup& group) {
    std::vector<std::uint64_t> idle_by_branch(graph_.blocks.size());
    std::uint64_t never_there = 0;
    for (std::uint32_t other = 0; other < lanes_.size(); ++other) {
      if ((group.lanes >> other & 1) != 0) continue;
      Parting latest;
      for_each_lane(group.lanes, [&](std::uint32_t lane) {
        if (lanes_[lane].parted_from[other].number > latest.number) latest = lanes_[lane].parted_from[other];
      });
      for_each_lane(group.lanes, [&](std::uint32_t lane) { lanes_[lane].parted_from[other] = latest; });
      (latest.number == 0 ? never_there : idle_by_branch[latest.branch]) |= std::uint64_t{1} << other;
    }
    for (std::uint32_t branch = 0; branch < idle_by_branch.size(); ++branch)
      if (idle_by_branch[branch] != 0) observer_.lanes_idled(group, branch, idle_by_branch[branch]);
    if (never_there != 0) observer_.lanes_idled(group, no_block, never_there);
  }

  const KernelGraph& graph_;
  std::unique_ptr<WarpSchedule> schedule_;
  std::vector<Lane> lanes_;  // [warp_width]
  WarpObserver& observer_;
  std::uint64_t exist_ = 0;
  std::uint64_t n_partings_ = 0;
};

}  // namespace

void check_warp_width(std::uint32_t width) {
  if (width < min_warp_width || width > max_warp_width || !std::has_single_bit(width))
    throw_input_error("warp width", fmt::format("{}", width),
                      fmt::format("a power of two from {} to {}", min_warp_width, max_warp_width));
}

void merge_warps(WarpMerger& merger, std::span<const LaneTrace> lanes, std::uint32_t width) {
  while (!lanes.empty()) {
    const std::size_t n = std::min<std::size_t>(width, lanes.size());
    merger.merge(lanes.first(n));
    lanes = lanes.subspan(n);
  }
}

std::unique_ptr<WarpMerger> make_observed_merger(const KernelGraph& graph, MergePolicy policy,
                                                 std::uint32_t warp_width, WarpObserver& observer) {
  return std::make_unique<ObservedMerger>(graph, policy, warp_width, observer);
}

}  // namespace warpgrain::profiler
