#include "profiler/lane_scheduler.hpp"

#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <limits>
#include <map>

#include "core/error.hpp"
#include "profiler/reconvergence.hpp"

namespace warpgrain::profiler {
namespace {

std::uint32_t take_lowest(std::uint32_t& lanes) {
  const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
  lanes &= lanes - 1;
  return lane;
}

std::uint32_t bit(std::uint32_t lane) { return std::uint32_t{1} << lane; }

std::size_t warps_of(std::size_t lanes) { return (lanes + lanes_of_warp - 1) / lanes_of_warp; }

}  // namespace

LaneScheduler::LaneScheduler(const TranslatedKernel& kernel, std::size_t lanes, std::size_t stack_bytes)
    : kernel_(kernel), fibers_(lanes, stack_bytes), barriers_(warps_of(lanes)), warps_(warps_of(lanes)) {
  if (kernel.graph.has_warp_level) rank_ = find_reconvergence(kernel.graph).rank;
}

const LaneContext* LaneScheduler::run(std::span<LaneContext> lanes, const std::string& group) {
  lanes_ = lanes;
  group_ = &group;
  n_running_ = lanes.size();
  barriers_.reset();
  for (std::size_t i = 0; i < lanes.size(); ++i) fibers_.start(i, kernel_.lane, &lanes[i]);
  for (std::size_t w = 0; w < warps_.size(); ++w) {
    const std::size_t n = std::min<std::size_t>(lanes.size() - w * lanes_of_warp, lanes_of_warp);
    const std::uint32_t exist = std::numeric_limits<std::uint32_t>::max() >> (lanes_of_warp - n);
    warps_[w] = {exist, exist, 0, 0};
  }
  for (;;) {
    for (std::size_t w = 0; w < warps_.size(); ++w)
      if (const LaneContext* stopped = run_warp(w)) return stopped;
    if (n_running_ == 0) return nullptr;
    if (!release_barriers()) refuse_waiting();
  }
}

// Until every lane of the warp has ended or waits for what others of the warp cannot give.
const LaneContext* LaneScheduler::run_warp(std::size_t w) {
  WarpState& warp = warps_[w];
  do {
    while (warp.ready != 0) {
      const std::uint32_t index = take_lowest(warp.ready);
      const LaneContext& context = lane(w, index);
      if (!fibers_.resume(w * lanes_of_warp + index)) {
        warp.alive &= ~bit(index);
        --n_running_;
        if (context.status != LaneStatus::done) return &context;
      } else if (is_of_warp(context.rendezvous.meeting)) {
        check_member(context, index);
        warp.meeting |= bit(index);
      } else {
        note_barrier(w, index);
      }
    }
  } while (warp.meeting != 0 && settle_warp(w));
  return nullptr;
}

void LaneScheduler::check_member(const LaneContext& context, std::uint32_t index) const {
  const Rendezvous& asked = context.rendezvous;
  if (asked.has_members != 0 && (asked.members & bit(index)) == 0)
    refuse(context, fmt::format("member mask {:#x}", asked.members),
           fmt::format("a mask with the lane's own bit, {:#x}", bit(index)));
}

void LaneScheduler::note_barrier(std::size_t w, std::uint32_t index) {
  const LaneContext& context = lane(w, index);
  const std::string_view fault = barriers_.arrive(context.rendezvous, w, index);
  if (!fault.empty()) refuse(context, fault, "what PTX allows");
  const bool waits = context.rendezvous.meeting != Meeting::barrier_arrive;
  (waits ? warps_[w].at_barrier : warps_[w].ready) |= bit(index);
}

bool LaneScheduler::settle_warp(std::size_t w) {
  WarpState& warp = warps_[w];
  std::uint32_t chosen = 0;
  std::uint64_t order = std::numeric_limits<std::uint64_t>::max();
  for (std::uint32_t left = warp.meeting; left != 0;) {
    const std::uint32_t index = take_lowest(left);
    const std::uint32_t together = meeting_of(w, index);
    left &= ~together;
    if (together == 0 || order_of(lane(w, index)) >= order) continue;
    chosen = together;
    order = order_of(lane(w, index));
  }
  if (chosen == 0) return false;
  WarpRendezvous rendezvous{};
  for (std::uint32_t left = chosen; left != 0;) {
    const std::uint32_t index = take_lowest(left);
    rendezvous[index] = &lane(w, index).rendezvous;
  }
  exchange_values(rendezvous, chosen);
  warp.meeting &= ~chosen;
  warp.ready |= chosen;
  return true;
}

std::uint32_t LaneScheduler::meeting_of(std::size_t w, std::uint32_t index) const {
  const LaneContext& first = lane(w, index);
  const Rendezvous& asked = first.rendezvous;
  std::uint32_t together = 0;
  for (std::uint32_t left = warps_[w].meeting; left != 0;) {
    const std::uint32_t other_index = take_lowest(left);
    const LaneContext& other = lane(w, other_index);
    const Rendezvous& also = other.rendezvous;
    const bool same_place = asked.has_members != 0 ? also.members == asked.members
                                                   : also.block == asked.block && other.line == first.line;
    if (also.meeting == asked.meeting && also.has_members == asked.has_members && same_place)
      together |= bit(other_index);
  }
  const std::uint32_t awaited = asked.has_members != 0 ? asked.members & warps_[w].alive : 0;
  return (awaited & ~together) == 0 ? together : 0;
}

std::uint64_t LaneScheduler::order_of(const LaneContext& context) const {
  return std::uint64_t{rank_[context.rendezvous.block]} << 32 | context.line;
}

bool LaneScheduler::release_barriers() {
  bool any = false;
  for (std::uint32_t barrier = 0; barrier < GroupBarriers::count; ++barrier)
    if (barriers_.is_complete(barrier, warps_)) {
      check_same_place(barrier);
      reduce(barrier);
      release(barrier);
      any = true;
    }
  return any;
}

template <class Function>
void LaneScheduler::for_each_at(std::uint32_t barrier, Function function) const {
  for (std::size_t w = 0; w < warps_.size(); ++w)
    for (std::uint32_t left = warps_[w].at_barrier; left != 0;) {
      const std::uint32_t index = take_lowest(left);
      if (lane(w, index).rendezvous.index == barrier) function(w, index);
    }
}

void LaneScheduler::release(std::uint32_t barrier) {
  for_each_at(barrier, [&](std::size_t w, std::uint32_t index) {
    warps_[w].at_barrier &= ~bit(index);
    warps_[w].ready |= bit(index);
  });
  barriers_.clear(barrier);
}

void LaneScheduler::reduce(std::uint32_t barrier) {
  std::uint64_t holding = 0, asking = 0;
  for_each_at(barrier, [&](std::size_t w, std::uint32_t index) {
    const Rendezvous& asked = lane(w, index).rendezvous;
    if (asked.meeting == Meeting::barrier) return;
    ++asking;
    holding += asked.value != 0 ? 1 : 0;
  });
  if (asking == 0) return;
  for_each_at(barrier, [&](std::size_t w, std::uint32_t index) {
    Rendezvous& asked = lane(w, index).rendezvous;
    asked.result = holding;
    asked.holds = asked.meeting == Meeting::barrier_and ? holding == asking : holding != 0;
  });
}

// OpenCL wants every work-item of the group at one barrier, PTX every lane of a warp where it says aligned.
void LaneScheduler::check_same_place(std::uint32_t barrier) const {
  std::size_t waiting = 0, warp_before = warps_.size();
  std::uint32_t line = 0;
  for_each_at(barrier, [&](std::size_t w, std::uint32_t index) {
    const LaneContext& context = lane(w, index);
    if (waiting++ == 0 || (w != warp_before && !kernel_.is_opencl)) line = context.line;
    warp_before = w;
    if (context.line != line && (kernel_.is_opencl || context.rendezvous.aligned != 0)) refuse_waiting();
  });
  if (kernel_.is_opencl && waiting < lanes_.size()) refuse_waiting();
}

void LaneScheduler::refuse(const LaneContext& context, std::string_view what,
                           std::string_view expected) const {
  throw_input_error(fmt::format("{}, {}, work-item {}", kernel_.place(), *group_, context.linear_tid),
                    fmt::format("{} at {}", what, kernel_.source_of(context.line)), expected);
}

void LaneScheduler::refuse_waiting() const {
  std::map<std::uint32_t, std::size_t> at_barrier, meeting;  // PTX line -> work-items
  for (std::size_t w = 0; w < warps_.size(); ++w) {
    for (std::uint32_t left = warps_[w].at_barrier; left != 0;) ++at_barrier[lane(w, take_lowest(left)).line];
    for (std::uint32_t left = warps_[w].meeting; left != 0;) ++meeting[lane(w, take_lowest(left)).line];
  }
  const bool only_barriers = meeting.empty();
  std::string what =
      fmt::format("{} in {}:", only_barriers ? "barrier divergence" : "deadlock between lanes", *group_);
  for (const auto& [line, count] : at_barrier)
    what += fmt::format(" {} work-items wait at {}{},", count, only_barriers ? "" : "the barrier at ",
                        kernel_.source_of(line));
  for (const auto& [line, count] : meeting)
    what += fmt::format(" {} wait for lanes of their warp at {},", count, kernel_.source_of(line));
  throw_input_error(kernel_.place(), fmt::format("{} {} have ended", what, lanes_.size() - n_running_),
                    only_barriers ? "every work-item of the group at the same barrier"
                                  : "every lane of a member mask at the same operation");
}

}  // namespace warpgrain::profiler
