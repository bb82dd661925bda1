#include "profiler/sass/lane_walker.hpp"

#include <algorithm>

#include "profiler/control_flow.hpp"
#include "profiler/sass/division_routine.hpp"
#include "profiler/sass/reached_blocks.hpp"

namespace warpgrain::profiler::sass {

LaneWalker::LaneWalker(const ReplayPlan& plan, const PtxDecisions& decisions, ReplayCounters& counters)
    : plan_(plan),
      counters_(counters),
      has_guard_(decisions.count(), false),
      follows_(decisions.count(), false),
      trips_left_(plan.loops.size()),
      paths_(decisions) {
  const KernelGraph& graph = decisions.graph();
  for (std::uint32_t b = 0; b < graph.blocks.size(); ++b) {
    std::uint32_t end = no_block;
    decisions.for_run(b, [&](std::uint32_t on_run) {
      if (decisions.at_end_of(on_run) != no_decision) end = on_run;
    });
    run_end_.push_back(end);
    runs_.emplace_back();
    decides_.push_back(end != no_block ? 1 : 0);
    if (end != no_block) runs_.back() = {decisions.at_end_of(end), graph.blocks[end].successors[0]};
  }
  for (const Node& node : plan.nodes)
    if (node.decision != no_decision && node.rule != Rule::fast_path && node.rule != Rule::unknown)
      has_guard_[node.decision] = true;
  for (const Node& node : plan.nodes) {
    if (node.rule == Rule::decision) follows_[node.decision] = true;
    record_of_.push_back(node.rule == Rule::path ? paths_.record_of(node.line) : no_record);
  }
  steps_.resize(plan.nodes.size());
  for (std::size_t n = 0; n < plan.nodes.size(); ++n) {
    const Node& node = plan.nodes[n];
    if (node.rule != Rule::decision) continue;
    Step& step = steps_[n];
    step.decision = node.decision;
    step.other_way = static_cast<std::uint8_t>(1 ^ node.taken_way);
    for (std::uint32_t went = 0; went < 2; ++went) {
      const Way& way = went == node.taken_way ? node.taken : node.next;
      step.has_events[went] = !way.events.empty();
      step.to[went] = steps_.data() + way.node;
    }
  }
  note_folded(decisions);
}

// `if (a && b)` may leave one guard of two decisions. Lanes for which a has settled it never come to b: their
// trace goes on where b would have sent them. From there b must not be reached before another guard.
void LaneWalker::note_folded(const PtxDecisions& decisions) {
  const KernelGraph& graph = decisions.graph();
  const auto reaches = [&](std::uint32_t from, std::uint32_t decision) {
    bool found = false;
    for_each_reached(graph.blocks.size(), from, [&](std::uint32_t b, auto&& go_on) {
      const std::uint32_t here = decisions.at_end_of(b);
      found |= here == decision;
      if (here == decision || (here != no_decision && has_guard_[here])) return;
      for (const std::uint32_t to : graph.blocks[b].successors) go_on(to);
    });
    return found;
  };
  folded_.resize(decisions.count());
  for (const Node& node : plan_.nodes) {
    if (node.rule != Rule::decision || !folded_[node.decision].empty()) continue;
    std::vector<std::uint8_t>& ways = folded_[node.decision];
    ways.assign(graph.blocks.size(), 0);
    for (const std::uint32_t b : decisions.blocks_of(node.decision))
      for (std::uint8_t way = 0; way < 2; ++way) {
        const std::uint32_t to = graph.blocks[b].successors[way];
        if (!reaches(to, node.decision)) ways[to] = static_cast<std::uint8_t>(1 + way);
      }
  }
}

std::uint32_t LaneWalker::index_of(const Node& node) const {
  return static_cast<std::uint32_t>(&node - plan_.nodes.data());
}

// These three are for every step of every lane.
inline void LaneWalker::choose(std::uint32_t way, Choices& choices) const {
  choices.add(way, static_cast<std::uint32_t>(trace_ - begin_));
}

inline bool LaneWalker::take_decision(const Node& node) {
  for (const BlockIndex* entry = trace_; *entry != trace_end; ++entry) {
    const std::uint32_t decision = runs_[*entry].decision;
    if (decision == node.decision) {
      trace_ = entry + 1;
      return (*trace_ == runs_[*entry].first_way ? 0U : 1U) == node.taken_way;
    }
    if (decision == no_decision) continue;
    if (has_guard_[decision]) continue;
    if (const std::uint8_t way = folded_[node.decision][*(entry + 1)]; way != 0) {
      trace_ = entry + 1;
      return way - 1U == node.taken_way;
    }
  }
  ++counters_.underived[index_of(node)];
  return false;
}

[[gnu::noinline]] std::uint32_t LaneWalker::pass_events(const Way& way) {
  for (const TripEvent& event : way.events) {
    std::int64_t& left = trips_left_[event.loop];
    if (event.copies == 0)
      left = count_trips(plan_.loops[event.loop]);
    else if (!event.predicated || left >= event.copies)
      left -= event.copies;
    if (left < 0) fits_ = false;
  }
  return way.node;
}

inline std::uint32_t LaneWalker::pass(const Way& way) {
  return way.events.empty() ? way.node : pass_events(way);
}

// A pass of its own, without branches that cannot be foretold: no entry has to wait for the one before it.
void LaneWalker::note_decisions() {
  // Members are copied so that they stay in registers.
  const BlockIndex* const begin = begin_;
  const std::uint8_t* const decides = decides_.data();
  std::uint32_t* decided = decided_.data();
  std::size_t n = 0, room = decided_.size();
  std::uint32_t k = 0;
  for (; begin[k] != trace_end; ++k) {
    decided[n] = k;
    n += decides[begin[k]];
    if (n < room) continue;
    decided_.resize(room *= 2);
    decided = decided_.data();
  }
  decided[n] = k;
  next_decided_ = decided;
}

// Which way the decision at a node went that does not come next in the trace.
[[gnu::noinline]] std::uint32_t LaneWalker::look_for_decision(std::uint32_t node, std::uint32_t left_behind) {
  trace_ = begin_ + left_behind;
  const bool taken = take_decision(plan_.nodes[node]);
  catch_up();
  return taken ? plan_.nodes[node].taken_way : 1 ^ plan_.nodes[node].taken_way;
}

void LaneWalker::catch_up() {
  while (*next_decided_ < static_cast<std::uint32_t>(trace_ - begin_)) ++next_decided_;
}

std::uint32_t LaneWalker::take_decisions(std::uint32_t from, std::size_t& steps, std::size_t budget,
                                         Choices& choices) {
  catch_up();
  // Members are copied so that they stay in registers; so do others, as what is seldom stands elsewhere.
  const Step* const all = steps_.data();
  const Run* const runs = runs_.data();
  const BlockIndex* const begin = begin_;
  const Step* step = all + from;
  const std::uint32_t* next = next_decided_;
  auto left_behind = static_cast<std::uint32_t>(trace_ - begin);  // entries
  const Choices::Room room = choices.room();
  const std::size_t most = std::min(room.count, budget - steps);
  std::size_t n = 0;
  for (; n < most; ++n) {
    const BlockIndex* const entry = begin + *next;
    std::uint32_t went = 0;
    if (*entry != trace_end && runs[*entry].decision == step->decision) {  // the usual case
      // No branch: which way lanes go cannot be foretold.
      went = *(entry + 1) == runs[*entry].first_way ? 0 : 1;
      left_behind = *next++ + 1;
    } else {
      if (step->decision == no_decision) break;
      next_decided_ = next;
      went = look_for_decision(static_cast<std::uint32_t>(step - all), left_behind);
      next = next_decided_;
      left_behind = static_cast<std::uint32_t>(trace_ - begin);
    }
    const std::uint32_t taken = went ^ step->other_way;
    room.ways[n] = static_cast<std::uint16_t>(taken);
    if (room.entries != nullptr) room.entries[n] = left_behind;
    if (step->has_events[went]) {
      trace_ = begin + left_behind;  // from here trips are counted
      const Node& node = plan_.nodes[static_cast<std::size_t>(step - all)];
      pass_events(taken != 0 ? node.taken : node.next);
    }
    step = step->to[went];
  }
  trace_ = begin + left_behind;
  next_decided_ = next;
  steps += n;
  choices.added(n);
  return static_cast<std::uint32_t>(step - all);
}

void LaneWalker::walk(const LaneTrace& lane, Choices& choices) {
  const BlockIndex* const trace = lane.blocks;
  begin_ = trace_ = trace;
  note_decisions();
  paths_.read(lane);
  returns_.clear();
  fits_ = true;
  std::uint32_t at = pass(plan_.entry);
  // A lane that takes no guard it should may go round and round.
  std::size_t steps = 0, budget = 1024;
  for (;;) {
    if (steps >= budget) {
      if (budget != 1024) break;
      for (const BlockIndex* entry = trace; *entry != trace_end; ++entry) budget += 64;
      if (steps >= budget) break;
    }
    at = take_decisions(at, steps, budget, choices);
    const Node& node = plan_.nodes[at];
    if (steps >= budget || node.rule == Rule::decision) continue;  // no room left, or too many
    ++steps;
    bool taken = false;
    switch (node.rule) {
      case Rule::trips:
        taken = take_trips(node);
        choose(taken ? 1 : 0, choices);
        break;
      case Rule::unknown:
        ++counters_.underived[at];
        choose(0, choices);
        break;
      case Rule::fast_path:
        ++counters_.fast_paths;
        taken = node.takes_fast_path;
        break;
      case Rule::path:
        path_ = paths_.next(record_of_[at]);
        if (lane.addresses == nullptr) ++counters_.fast_paths;
        taken = (path_ == DivisionPath::in_line) == node.takes_fast_path;
        choose(taken ? 1 : 0, choices);
        break;
      case Rule::routine:
        taken = takes_division_guard(node.guard, path_);
        choose(taken ? 1 : 0, choices);
        break;
      case Rule::together:
      case Rule::decision:  // has been taken
        break;
      case Rule::indirect: {
        const std::uint32_t entry = take_indirect(node);
        choose(entry, choices);
        at = pass(node.table[entry]);
        continue;
      }
      case Rule::call:
        returns_.push_back(at);
        taken = true;
        break;
      case Rule::ret:
        if (returns_.empty()) {
          ++counters_.out_of_step;
          return;
        }
        at = pass(plan_.nodes[returns_.back()].next);
        returns_.pop_back();
        continue;
      case Rule::end:
        for (; *trace_ != trace_end; ++trace_)
          if (runs_[*trace_].decision != no_decision && follows_[runs_[*trace_].decision]) fits_ = false;
        if (!fits_) ++counters_.out_of_step;
        return;
    }
    at = pass(taken ? node.taken : node.next);
  }
  ++counters_.out_of_step;
}

bool LaneWalker::take_trips(const Node& node) {
  const std::int64_t left = trips_left_[node.loop];
  const auto possible = [&](const TripSide& side) {
    if (side.leaves) return side.copies == left || (side.maybe != 0 && side.copies + side.maybe == left);
    return side.copies <= left && (side.unit == 0 || (left - side.copies) % side.unit == 0);
  };
  const bool taken = possible(node.taken_side), next = possible(node.next_side);
  if (taken != next) return taken;
  // A lane without a trip left goes where the loop is left at once: the guard before an unrolled loop asks
  // whether there is any trip, though those behind it would let the lane through, too.
  const auto is_exit = [](const TripSide& side) { return side.leaves && side.copies == 0; };
  if (taken && left == 0 && is_exit(node.taken_side) != is_exit(node.next_side))
    return is_exit(node.taken_side);
  // Where both would do, the way with few copies at a time is for counts that wrap around.
  const auto usual = [](const TripSide& a, const TripSide& b) {
    return a.most != b.most ? a.most > b.most : a.copies < b.copies;
  };
  const bool is_taken = usual(node.taken_side, node.next_side);
  if (taken && is_taken != usual(node.next_side, node.taken_side)) {
    ++counters_.trips_assumed;
    return is_taken;
  }
  ++counters_.underived[index_of(node)];
  return false;
}

std::uint32_t LaneWalker::take_indirect(const Node& node) {
  if (*trace_ != trace_end)
    for (const BlockIndex* entry = trace_ + 1; *entry != trace_end; ++entry)
      if (node.table_of[*entry] != no_code) {
        trace_ = entry;
        return node.table_of[*entry];
      }
  ++counters_.underived[index_of(node)];
  return 0;
}

std::int64_t LaneWalker::count_trips(const TripLoop& loop) const {
  std::int64_t trips = 0;
  bool entered = false;
  for (const BlockIndex* entry = trace_; *entry != trace_end; ++entry) {
    if (loop.counts[*entry]) ++trips;
    const std::uint32_t end = run_end_[*entry];
    if (end == no_block) continue;
    if (loop.inside[end]) {
      entered = true;
      if (!loop.inside[*(entry + 1)]) break;
    } else if (entered || follows_[runs_[*entry].decision]) {
      break;
    }
  }
  return trips;
}

}  // namespace warpgrain::profiler::sass
