#include "profiler/sass/warp_groups.hpp"

#include <algorithm>
#include <bit>
#include <tuple>
#include <utility>

namespace warpgrain::profiler::sass {
namespace {

bool is_same_place(const WarpGroup& a, const WarpGroup& b) {
  return a.block == b.block && a.stand == b.stand && a.frame == b.frame;
}

}  // namespace

WarpGroups::WarpGroups(const CodeGraph& code, ReplayCounters& counters)
    : code_(code), counters_(counters), partings_(counters.lane_slots_lost) {}

void WarpGroups::begin(Mask lanes) {
  alive_ = lanes;
  yielded_lanes_ = 0;
  next_lane_ = 0;
  barriers_.clear();
  turn_ = WarpGroup{lanes, 0, no_frame, partings_.root(counters_.never_used(), ~lanes)};
}

bool WarpGroups::next(WarpGroup& group) {
  if (turn_) {
    group = *std::exchange(turn_, std::nullopt);
    return true;
  }
  if (choose(group, nullptr)) return true;
  if (waiting_.empty()) return false;
  force(group);
  return true;
}

void WarpGroups::give_up() {
  for (std::vector<WarpGroup>* groups : {&standing_, &waiting_, &yielded_}) {
    for (const WarpGroup& group : *groups) partings_.release(group.node);
    groups->clear();
  }
  for (std::optional<WarpGroup>* group : {&turn_, &put_off_})
    if (*group) partings_.release(std::exchange(*group, std::nullopt)->node);
}

void WarpGroups::put_off(const WarpGroup& group) {
  if (put_off_) standing_.push_back(*put_off_);
  put_off_ = group;
}

void WarpGroups::end(const WarpGroup& group) {
  alive_ &= ~group.lanes;
  partings_.release(group.node);
}

void WarpGroups::act(const MaskAction& action, Mask lanes) {
  switch (action.flow) {
    case Flow::open:
      barriers_.at(action.barrier, lanes) |= lanes;
      break;
    case Flow::save:
      barriers_.save(action.barrier, lanes);
      break;
    case Flow::restore:
      barriers_.restore(action.barrier, lanes);
      break;
    default:
      break;
  }
}

void WarpGroups::leave(std::uint8_t barrier, Mask lanes) {
  if (lanes != 0) barriers_.at(barrier, lanes) &= ~lanes;
}

bool WarpGroups::gives_way(const WarpGroup& group) {
  const auto let_go =
      std::ranges::find_if(waiting_, [&](const WarpGroup& waiting) { return can_pass(waiting); });
  if (let_go == waiting_.end()) return false;
  const WarpGroup released = *let_go;
  waiting_.erase(let_go);
  if (std::popcount(released.lanes) >= std::popcount(group.lanes)) {
    put_off(released);
    return false;
  }
  put_off(group);
  turn_ = released;
  return true;
}

bool WarpGroups::is_known(const WarpGroup& group, std::uint8_t barrier) const {
  return (barriers_.at(barrier, group.lanes) & group.lanes) != 0;
}

// The lanes that a meeting of the group waits for.
Mask WarpGroups::missing_at(const WarpGroup& group, std::uint8_t barrier) const {
  Mask missing = barriers_.at(barrier, group.lanes) & alive_ & ~yielded_lanes_ & ~group.lanes;
  for (const WarpGroup& other : waiting_) {
    const CodeBlock& block = code_.blocks[other.block];
    if (block.end == End::meet && block.barrier == barrier &&
        barriers_.is_same(barrier, other.lanes, group.lanes))
      missing &= ~other.lanes;
  }
  return missing;
}

bool WarpGroups::can_pass(const WarpGroup& group) const {
  const CodeBlock& block = code_.blocks[group.block];
  if (block.end == End::warp_meet) return group.lanes == alive_;
  return !is_known(group, block.barrier) || missing_at(group, block.barrier) == 0;
}

void WarpGroups::join_those_at(std::vector<WarpGroup>& groups, WarpGroup& group) {
  std::erase_if(groups, [&](const WarpGroup& other) {
    if (!is_same_place(other, group)) return false;
    group.node = partings_.join(group.node, other.node, group.lanes | other.lanes);
    group.lanes |= other.lanes;
    return true;
  });
}

bool WarpGroups::meet(WarpGroup& group, std::uint8_t barrier) {
  if (!is_known(group, barrier)) return true;
  const bool all_here = missing_at(group, barrier) == 0;
  if (all_here) barriers_.at(barrier, group.lanes) = 0;
  join_those_at(waiting_, group);
  if (!all_here) waiting_.push_back(group);
  return all_here;
}

bool WarpGroups::meet_warp(WarpGroup& group) {
  join_those_at(waiting_, group);
  if (group.lanes == alive_) return true;
  waiting_.push_back(group);
  return false;
}

bool WarpGroups::yield(const WarpGroup& group) {
  if (group.lanes == alive_) return false;
  yielded_lanes_ |= group.lanes;
  WarpGroup other;
  if (!choose(other, &group)) {
    yielded_lanes_ &= ~group.lanes;
    return false;
  }
  pass_lanes(other);
  ++counters_.turns_assumed;
  turn_ = other;
  return true;
}

// `yields` is the group that has just yielded, which is put aside unless nobody else is found.
bool WarpGroups::choose(WarpGroup& group, const WarpGroup* yields) {
  if (put_off_)
    group = *std::exchange(put_off_, std::nullopt);
  else if (!choose_place(group))
    return choose_yielded(group, yields);
  if (yields != nullptr) yielded_.push_back(*yields);
  return true;
}

// The place with the fewest lanes of those that can run from there.
bool WarpGroups::choose_place(WarpGroup& group) {
  std::optional<std::tuple<int, std::uint32_t, Stand>> best;
  const auto consider = [&](const WarpGroup& candidate) {
    Mask lanes = 0;
    for (const WarpGroup& other : standing_)
      if (is_same_place(other, candidate)) lanes |= other.lanes;
    for (const WarpGroup& other : waiting_)
      if (is_same_place(other, candidate) && can_pass(other)) lanes |= other.lanes;
    const std::tuple place(std::popcount(lanes), candidate.block, candidate.stand);
    if (best && *best <= place) return;
    best = place;
    group = candidate;
  };
  for (const WarpGroup& candidate : standing_) consider(candidate);
  for (const WarpGroup& candidate : waiting_)
    if (can_pass(candidate)) consider(candidate);
  if (!best) return false;
  for (std::vector<WarpGroup>* groups : {&standing_, &waiting_}) {
    const auto itself = std::ranges::find(*groups, group.lanes, &WarpGroup::lanes);
    if (itself != groups->end()) groups->erase(itself);
  }
  join_those_at(standing_, group);
  join_those_at(waiting_, group);
  return true;
}

bool WarpGroups::choose_yielded(WarpGroup& group, const WarpGroup* yields) {
  if (yielded_.empty()) return false;
  const auto distance = [&](const WarpGroup& candidate) {
    return std::countr_zero(std::rotr(candidate.lanes, static_cast<int>(next_lane_)));
  };
  const auto chosen = std::ranges::min_element(yielded_, {}, distance);
  next_lane_ = (next_lane_ + static_cast<std::uint32_t>(distance(*chosen))) % replayed_warp_width;
  group = *chosen;
  yielded_.erase(chosen);
  if (yields != nullptr) yielded_.push_back(*yields);
  join_those_at(yielded_, group);
  yielded_lanes_ &= ~group.lanes;
  pass_lanes(group);
  return true;
}

// The turn after that of lanes that have been chosen is that of the first behind them.
void WarpGroups::pass_lanes(const WarpGroup& chosen) {
  const auto passed = std::countr_one(std::rotr(chosen.lanes, static_cast<int>(next_lane_)));
  next_lane_ = (next_lane_ + static_cast<std::uint32_t>(passed)) % replayed_warp_width;
}

// Nobody can go on. WARPSYNC's mask is in a register that the replay does not know: it meets those that
// have come when no other can.
void WarpGroups::force(WarpGroup& group) {
  const auto order = [&](const WarpGroup& waiting) {
    return std::pair(code_.blocks[waiting.block].end != End::warp_meet, waiting.block);
  };
  const auto chosen = std::ranges::min_element(waiting_, {}, order);
  if (order(*chosen).first) ++counters_.stuck;
  group = *chosen;
  waiting_.erase(chosen);
  join_those_at(waiting_, group);
  group.block = code_.blocks[group.block].next;
}

}  // namespace warpgrain::profiler::sass
