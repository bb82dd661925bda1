#include "profiler/sass/warp_groups.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace warpgrain::profiler::sass {

WarpGroups::WarpGroups(const CodeGraph& code, ReplayCounters& counters)
    : code_(code), counters_(counters), partings_(counters.lane_slots_lost) {}

void WarpGroups::begin(Mask lanes) {
  alive_ = lanes;
  yielded_lanes_ = 0;
  barriers_.clear();
  ready_.push_back({lanes, 0, no_frame, partings_.root(counters_.never_used(), ~lanes)});
}

bool WarpGroups::next(WarpGroup& group) {
  if (ready_.empty() && !resume() && !release_any()) {
    if (waiting_.empty()) return false;
    force_release();
  }
  group = ready_.back();
  ready_.pop_back();
  return true;
}

void WarpGroups::give_up() {
  for (std::vector<WarpGroup>* groups : {&ready_, &waiting_, &yielded_}) {
    for (const WarpGroup& group : *groups) partings_.release(group.node);
    groups->clear();
  }
}

void WarpGroups::end(const WarpGroup& group) {
  alive_ &= ~group.lanes;
  partings_.release(group.node);
  if (!waiting_.empty()) release_any();
}

void WarpGroups::act(const MaskAction& action, Mask lanes) {
  switch (action.flow) {
    case Flow::open:
      barriers_.at(action.barrier, lanes) |= lanes;
      break;
    case Flow::leave:
      if (action.lanes == MaskAction::Lanes::all) leave(action.barrier, lanes);
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
  if (lanes == 0) return;
  barriers_.at(barrier, lanes) &= ~lanes;
  left_ = true;
}

void WarpGroups::end_leaving() {
  if (left_ && !waiting_.empty()) release_any();
  left_ = false;
}

bool WarpGroups::meet(const WarpGroup& group, std::uint8_t barrier) {
  if (comes_alone(group, barrier)) return true;
  waiting_.push_back(group);
  release_any();
  return false;
}

bool WarpGroups::meet_warp(const WarpGroup& group) {
  if (group.lanes == alive_) return true;
  waiting_.push_back(group);
  return false;
}

bool WarpGroups::yield(const WarpGroup& group) {
  if (group.lanes == alive_) return false;
  yielded_lanes_ |= group.lanes;
  yielded_.push_back(group);
  return true;
}

// Groups that have yielded go on, those at one place together. Whether there were any.
bool WarpGroups::resume() {
  if (yielded_.empty()) return false;
  yielded_lanes_ = 0;
  for (const WarpGroup& group : yielded_) {
    const auto same = std::ranges::find_if(ready_, [&](const WarpGroup& other) {
      return other.block == group.block && other.frame == group.frame;
    });
    if (same == ready_.end()) {
      ready_.push_back(group);
      continue;
    }
    same->lanes |= group.lanes;
    same->node = partings_.join(same->node, group.node, same->lanes);
  }
  yielded_.clear();
  return true;
}

void WarpGroups::issue_again(const WarpGroup& group, std::uint32_t block) {
  const auto n_lanes = static_cast<std::uint32_t>(std::popcount(group.lanes));
  ++counters_.issued_again[std::size_t{block} * (replayed_warp_width + 1) + n_lanes];
  partings_.issue(group.node, 1);
}

// Lanes that a meeting waits for. None for a group that the barrier does not know: it has been emptied
// while these had yielded.
Mask WarpGroups::expected(const WarpGroup& group, std::uint8_t barrier) const {
  const Mask lanes = barriers_.at(barrier, group.lanes);
  return (lanes & group.lanes) == 0 ? 0 : lanes & alive_ & ~yielded_lanes_;
}

bool WarpGroups::waits_at(const WarpGroup& other, const WarpGroup& group, std::uint8_t barrier) const {
  const CodeBlock& block = code_.blocks[other.block];
  return block.end == End::meet && block.barrier == barrier &&
         barriers_.is_same(barrier, other.lanes, group.lanes);
}

// Whether a group goes through a meeting for which it need not wait, and for which nobody waits.
bool WarpGroups::comes_alone(const WarpGroup& group, std::uint8_t barrier) {
  if ((barriers_.at(barrier, group.lanes) & group.lanes) == 0) return true;
  if ((expected(group, barrier) & ~group.lanes) != 0) return false;
  for (const WarpGroup& other : waiting_)
    if (waits_at(other, group, barrier)) return false;
  barriers_.at(barrier, group.lanes) = 0;
  return true;
}

// Lets groups go on whose others have all come, ended, left or yielded. Whether there was one.
bool WarpGroups::release_any() {
  bool released = false;
  for (std::size_t k = 0; k < waiting_.size();) {
    const WarpGroup group = waiting_[k];
    const CodeBlock& block = code_.blocks[group.block];
    const bool of_warp = block.end == End::warp_meet;
    Mask here = 0;
    for (const WarpGroup& other : waiting_)
      if (of_warp ? other.block == group.block : waits_at(other, group, block.barrier)) here |= other.lanes;
    const Mask needed = of_warp ? alive_ : expected(group, block.barrier);
    if ((needed & ~here) != 0) {
      ++k;
      continue;
    }
    release(group, of_warp ? alive_ : std::exchange(barriers_.at(block.barrier, group.lanes), 0));
    released = true;
    k = 0;
  }
  return released;
}

// Groups at the place of one, in the same call, go on: what they have of the lanes that met as one, and as
// another what came with these.
void WarpGroups::release(const WarpGroup& first, Mask lanes) {
  WarpGroup met{0, code_.blocks[first.block].next, first.frame, 0}, others = met;
  const auto join = [&](WarpGroup& joined, Mask mask, Partings::Node node) {
    joined.node = joined.lanes == 0 ? node : partings_.join(joined.node, node, joined.lanes | mask);
    joined.lanes |= mask;
  };
  std::erase_if(waiting_, [&](const WarpGroup& group) {
    if (group.block != first.block || group.frame != first.frame) return false;
    if (left_) issue_again(group, group.block);
    const Mask in = group.lanes & lanes, out = group.lanes & ~lanes;
    if (in == 0 || out == 0) {
      join(in != 0 ? met : others, group.lanes, group.node);
      return true;
    }
    ++n_partings_;
    const std::uint32_t nobody = counters_.never_used();
    join(met, in, partings_.part(group.node, nobody, out, n_partings_));
    join(others, out, partings_.part(group.node, nobody, in, n_partings_));
    partings_.release(group.node);
    return true;
  });
  if (others.lanes != 0) ready_.push_back(others);
  if (met.lanes != 0) ready_.push_back(met);
}

// Nobody can go on. WARPSYNC's mask is in a register that the replay does not know: it meets those that
// have come when no other can.
void WarpGroups::force_release() {
  std::size_t chosen = waiting_.size();
  for (std::size_t k = 0; k < waiting_.size(); ++k) {
    if (code_.blocks[waiting_[k].block].end != End::warp_meet) continue;
    if (chosen == waiting_.size() || waiting_[k].block < waiting_[chosen].block) chosen = k;
  }
  if (chosen == waiting_.size()) {
    ++counters_.stuck;
    chosen = 0;
    for (std::size_t k = 1; k < waiting_.size(); ++k)
      if (waiting_[k].block < waiting_[chosen].block) chosen = k;
  }
  release(WarpGroup(waiting_[chosen]), ~Mask{0});
}

}  // namespace warpgrain::profiler::sass
