#include "profiler/lane_scheduler.hpp"

#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <utility>

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

void LaneScheduler::run(std::span<LaneContext> lanes, LaneEvents& events) {
  lanes_ = lanes;
  events_ = &events;
  n_running_ = lanes.size();
  warps_.resize(warps_of(lanes.size()));
  barriers_.reset();
  for (std::size_t i = 0; i < lanes.size(); ++i) fibers_.start(i, kernel_.lane, &lanes[i]);
  for (std::size_t w = 0; w < warps_.size(); ++w) {
    const std::size_t n = std::min<std::size_t>(lanes.size() - w * lanes_of_warp, lanes_of_warp);
    const std::uint32_t exist = std::numeric_limits<std::uint32_t>::max() >> (lanes_of_warp - n);
    warps_[w] = {exist, exist, 0, 0};
  }
  for (;;) {
    for (std::size_t w = 0; w < warps_.size(); ++w) run_warp(w);
    if (n_running_ == 0 || events.given_up()) return;
    if (release_barriers()) continue;
    tell_stuck();
    wake_all();
  }
}

// Until every lane of the warp has ended or waits for what others of the warp cannot give.
void LaneScheduler::run_warp(std::size_t w) {
  WarpState& warp = warps_[w];
  do {
    while (warp.ready != 0) {
      if (events_->given_up()) return;
      const std::uint32_t index = take_lowest(warp.ready);
      const LaneContext& context = lane(w, index);
      if (!fibers_.resume(w * lanes_of_warp + index)) {
        warp.alive &= ~bit(index);
        --n_running_;
        events_->lane_ended(w * lanes_of_warp + index);
      } else if (is_of_warp(context.rendezvous.meeting)) {
        check_member(context, index);
        warp.meeting |= bit(index);
      } else {
        note_barrier(w, index);
      }
    }
  } while (warp.meeting != 0 && settle_warp(w));
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
  if (waits) return;
  const std::size_t arrived = w * lanes_of_warp + index;
  events_->lanes_met(std::span(&arrived, 1), false);
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
  met_.clear();
  for (std::uint32_t left = chosen; left != 0;) {
    const std::uint32_t index = take_lowest(left);
    rendezvous[index] = &lane(w, index).rendezvous;
    met_.push_back(w * lanes_of_warp + index);
  }
  exchange_values(rendezvous, chosen);
  warp.meeting &= ~chosen;
  warp.ready |= chosen;
  events_->lanes_met(met_, true);
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
      if (!is_at_one_place(barrier)) tell_stuck();
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
  met_.clear();
  for_each_at(barrier, [&](std::size_t w, std::uint32_t index) {
    warps_[w].at_barrier &= ~bit(index);
    warps_[w].ready |= bit(index);
    met_.push_back(w * lanes_of_warp + index);
  });
  barriers_.clear(barrier);
  events_->lanes_met(met_, false);
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
bool LaneScheduler::is_at_one_place(std::uint32_t barrier) const {
  bool at_one = true;
  std::size_t waiting = 0, warp_before = warps_.size();
  std::uint32_t line = 0;
  for_each_at(barrier, [&](std::size_t w, std::uint32_t index) {
    const LaneContext& context = lane(w, index);
    if (waiting++ == 0 || (w != warp_before && !kernel_.is_opencl)) line = context.line;
    warp_before = w;
    if (context.line != line && (kernel_.is_opencl || context.rendezvous.aligned != 0)) at_one = false;
  });
  return at_one && (!kernel_.is_opencl || waiting == lanes_.size());
}

void LaneScheduler::wake_all() {
  for (std::uint32_t barrier = 0; barrier < GroupBarriers::count; ++barrier) release(barrier);
  for (std::size_t w = 0; w < warps_.size(); ++w) {
    for (std::uint32_t left = warps_[w].meeting; left != 0;) lane(w, take_lowest(left)).rendezvous.result = 0;
    warps_[w].ready |= std::exchange(warps_[w].meeting, 0);
  }
}

void LaneScheduler::refuse(const LaneContext& context, std::string_view what,
                           std::string_view expected) const {
  throw_input_error(fmt::format("{}, work-group ({}, {}, {}), work-item {}", kernel_.place(),
                                context.ctaid[0], context.ctaid[1], context.ctaid[2], context.linear_tid),
                    fmt::format("{} at {}", what, place_text(kernel_.source_of(context.line))), expected);
}

void LaneScheduler::tell_stuck() const {
  std::map<std::uint32_t, std::size_t> at_barrier, meeting;  // PTX line -> work-items
  std::size_t first = lanes_.size();
  const auto count = [&](std::size_t w, std::uint32_t lanes, auto& waiting) {
    while (lanes != 0) {
      const std::uint32_t index = take_lowest(lanes);
      ++waiting[lane(w, index).line];
      first = std::min(first, w * lanes_of_warp + index);
    }
  };
  for (std::size_t w = 0; w < warps_.size(); ++w) {
    count(w, warps_[w].at_barrier, at_barrier);
    count(w, warps_[w].meeting, meeting);
  }
  const auto source = [&](std::uint32_t line) { return place_text(kernel_.source_of(line)); };
  std::string who = meeting.empty() ? "" : "deadlock between lanes: ";
  for (const auto& [line, n] : at_barrier)
    who += fmt::format("{} work-items wait at {}{}, ", n, meeting.empty() ? "" : "the barrier at ",
                       source(line));
  for (const auto& [line, n] : meeting)
    who += fmt::format("{} wait for lanes of their warp at {}, ", n, source(line));
  events_->lanes_stuck(first, fmt::format("{}{} have ended", who, lanes_.size() - n_running_));
}

}  // namespace warpgrain::profiler
