#pragma once
// Runs the lanes of a work-group that wait for each other: at barriers, and at operations between the lanes
// of a warp.
//
// A lane runs natively until it has to wait. Lanes of a warp meet when all that the member mask names, and
// that have not ended, ask for the same; instructions without a mask (activemask, and the forms older than
// Volta) take the lanes that wait at that very instruction when no other of the warp can run, the place that
// comes first in the order of `loop_postdom` before others. That is the view of a warp which joins wherever
// it can.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "profiler/fiber_pool.hpp"
#include "profiler/group_barriers.hpp"
#include "profiler/translated_kernel.hpp"
#include "profiler/warp_exchange.hpp"

namespace warpgrain::profiler {

// What the scheduler tells of lanes, by their number in the work-group.
class LaneEvents {
 public:
  virtual void lane_ended(std::size_t lane) = 0;
  virtual bool given_up() const = 0;  // the lanes that are left need not run
  // They have waited for each other; of_warp: for an operation of their warp.
  virtual void lanes_met(std::span<const std::size_t> lanes, bool of_warp) = 0;
  // Lanes wait that nothing can wake, `lane` among them: barrier divergence, a warp whose lanes wait for each
  // other at different places. They go on as if what they wait for had happened.
  virtual void lanes_stuck(std::size_t lane, const std::string& who) = 0;

 protected:
  ~LaneEvents() = default;
};

class LaneScheduler {
 public:
  // `stack_bytes` for each lane's own frames.
  LaneScheduler(const TranslatedKernel& kernel, std::size_t lanes, std::size_t stack_bytes);

  // Runs all lanes of a work-group to their ends. Throws InputError for what PTX does not allow a lane to ask
  // for.
  void run(std::span<LaneContext> lanes, LaneEvents& events);

 private:
  void run_warp(std::size_t warp);
  void check_member(const LaneContext& context, std::uint32_t lane) const;
  void note_barrier(std::size_t warp, std::uint32_t lane);
  // Lets lanes of the warp meet that can; false when none can.
  bool settle_warp(std::size_t warp);
  // The lanes that meet the one at `lane`, when they are complete; else none.
  std::uint32_t meeting_of(std::size_t warp, std::uint32_t lane) const;
  // Wakes those whose barrier is complete; false when none is.
  bool release_barriers();
  void release(std::uint32_t barrier);
  void reduce(std::uint32_t barrier);
  bool is_at_one_place(std::uint32_t barrier) const;

  template <class Function>
  void for_each_at(std::uint32_t barrier, Function function) const;
  LaneContext& lane(std::size_t warp, std::uint32_t index) const {
    return lanes_[warp * lanes_of_warp + index];
  }
  std::uint64_t order_of(const LaneContext& lane) const;
  [[noreturn]] void refuse(const LaneContext& lane, std::string_view what, std::string_view expected) const;
  void tell_stuck() const;
  void wake_all();

  const TranslatedKernel& kernel_;
  std::vector<std::uint32_t> rank_;  // [n_blocks]; empty without operations of a warp
  FiberPool fibers_;
  GroupBarriers barriers_;
  std::vector<WarpState> warps_;
  std::span<LaneContext> lanes_;
  LaneEvents* events_ = nullptr;
  std::vector<std::size_t> met_;
  std::size_t n_running_ = 0;  // lanes that have not ended
};

}  // namespace warpgrain::profiler
