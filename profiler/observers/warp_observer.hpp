#pragma once
// What happens while the lanes of a warp are merged, for whoever wants to see it event by event.

#include <cstdint>
#include <span>

#include "profiler/merge_policy.hpp"

namespace warpgrain::profiler {

class WarpObserver {
 public:
  virtual ~WarpObserver() = default;

  // The warps that follow are of a launch of this kernel; it outlives them.
  virtual void launch_begins(const KernelGraph& graph) { (void)graph; }

  // A warp begins; `lanes`, at least one, are those that exist.
  virtual void warp_begins(std::uint64_t lanes) { (void)lanes; }

  // The warp issues a block for the lanes of `group`. `addresses` is [number of active lanes], lowest lane
  // first: a pointer to the addresses of the block's accesses, in their order; empty when they were not
  // recorded.
  virtual void block_issued(const LaneGroup& group, std::span<const std::uint64_t* const> addresses) {
    (void)group, (void)addresses;
  }

  // `group` has executed the conditional branch at the end of its block; `taken` are the lanes that went to
  // the first successor, `parts` where all of them went.
  virtual void branch_executed(const LaneGroup& group, std::uint64_t taken,
                               std::span<const LaneGroup> parts) {
    (void)group, (void)taken, (void)parts;
  }

  // While `group` ran its block, `idle` lanes waited or had ended because the branch at the end of block
  // `branch` had parted them from it. no_block: they were never there.
  virtual void lanes_idled(const LaneGroup& group, std::uint32_t branch, std::uint64_t idle) {
    (void)group, (void)branch, (void)idle;
  }
};

// Passes every event on to two.
class ObserverPair : public WarpObserver {
 public:
  ObserverPair(WarpObserver& first, WarpObserver& second) : first_(first), second_(second) {}
  void launch_begins(const KernelGraph& graph) override {
    first_.launch_begins(graph);
    second_.launch_begins(graph);
  }
  void warp_begins(std::uint64_t lanes) override {
    first_.warp_begins(lanes);
    second_.warp_begins(lanes);
  }
  void block_issued(const LaneGroup& group, std::span<const std::uint64_t* const> addresses) override {
    first_.block_issued(group, addresses);
    second_.block_issued(group, addresses);
  }
  void branch_executed(const LaneGroup& group, std::uint64_t taken,
                       std::span<const LaneGroup> parts) override {
    first_.branch_executed(group, taken, parts);
    second_.branch_executed(group, taken, parts);
  }
  void lanes_idled(const LaneGroup& group, std::uint32_t branch, std::uint64_t idle) override {
    first_.lanes_idled(group, branch, idle);
    second_.lanes_idled(group, branch, idle);
  }

 private:
  WarpObserver& first_;
  WarpObserver& second_;
};

}  // namespace warpgrain::profiler
