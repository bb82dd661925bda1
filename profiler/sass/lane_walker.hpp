#pragma once
// A lane's way through the machine code, from its trace.

#include <array>
#include <cstdint>
#include <vector>

#include "profiler/sass/recorded_paths.hpp"
#include "profiler/sass/replay_counters.hpp"
#include "profiler/sass/replay_plan.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler::sass {

// What a lane chose at each node of its way, in order: at guards whose rule is decision, trips or unknown 1
// if it took the guard, else 0; at indirect branches the entry of the table. Other nodes leave no choice.
class Choices {
 public:
  static constexpr std::uint16_t none = 0xFFFF;  // behind the last one of a lane

  std::size_t size() const { return size_; }
  const std::uint16_t* ways() const { return ways_.data(); }
  // How many entries of its trace the lane had left behind when it chose, by place in ways(); kept only if
  // that was asked for.
  std::uint32_t entries(std::size_t choice) const { return entries_[choice]; }
  void clear(bool with_entries) {
    size_ = 0;
    if (with_entries) entries_.resize(ways_.size());
    with_entries_ = with_entries;
  }
  void add(std::uint32_t way, std::uint32_t left_behind) {
    const Room at = room();
    at.ways[0] = static_cast<std::uint16_t>(way);
    if (at.entries != nullptr) at.entries[0] = left_behind;
    ++size_;
  }
  // Where the next ones go; `count` is at least 1. They are not there before added(): for loops that add
  // many.
  struct Room {
    std::uint16_t* ways;
    std::uint32_t* entries;  // null: not kept
    std::size_t count;
  };
  Room room() {
    if (size_ == ways_.size()) grow();
    return {ways_.data() + size_, with_entries_ ? entries_.data() + size_ : nullptr, ways_.size() - size_};
  }
  void added(std::size_t count) { size_ += count; }

 private:
  void grow() {
    ways_.resize(2 * size_ + 1024);
    if (with_entries_) entries_.resize(ways_.size());
  }
  bool with_entries_ = false;
  std::vector<std::uint16_t> ways_;
  std::vector<std::uint32_t> entries_;
  std::size_t size_ = 0;
};

// One a thread.
class LaneWalker {
 public:
  // What cannot be derived is counted. All outlive the walker.
  LaneWalker(const ReplayPlan& plan, const PtxDecisions& decisions, ReplayCounters& counters);

  // Appends the choices of the lane with that trace.
  void walk(const LaneTrace& lane, Choices& choices);

 private:
  struct Run {                             // what an entry of the trace stands for
    std::uint32_t decision = no_decision;  // at its end
    std::uint32_t first_way = no_code;     // the block to which the first way of the decision goes
  };

  // What walking needs of a node that asks for a decision: most steps are of these. Which step comes next is
  // known when the last one is, so what leads there is one load: all is by the way of the decision that the
  // lane went.
  struct Step {
    std::uint32_t decision = no_decision;  // none: the node has another rule
    std::uint8_t other_way = 0;            // of the decision, that does not take the guard
    std::array<bool, 2> has_events{};
    std::array<const Step*, 2> to{};
  };

  void choose(std::uint32_t way, Choices& choices) const;
  void note_decisions();
  void catch_up();
  std::uint32_t look_for_decision(std::uint32_t node, std::uint32_t left_behind);
  // Takes one decision after another from a node on; the first other node.
  std::uint32_t take_decisions(std::uint32_t from, std::size_t& steps, std::size_t budget, Choices& choices);
  void note_folded(const PtxDecisions& decisions);
  bool take_decision(const Node& node);
  bool take_trips(const Node& node);
  std::uint32_t take_indirect(const Node& node);
  std::uint32_t pass_events(const Way& way);
  std::uint32_t pass(const Way& way);  // the node that it leads to
  std::int64_t count_trips(const TripLoop& loop) const;
  std::uint32_t index_of(const Node& node) const;

  const ReplayPlan& plan_;
  ReplayCounters& counters_;
  std::vector<Step> steps_;             // [nodes]
  std::vector<Run> runs_;               // [blocks of the PTX]
  std::vector<std::uint8_t> decides_;   // [blocks of the PTX]: 1 if its run ends in a decision
  std::vector<std::uint32_t> run_end_;  // [blocks of the PTX]: the block with the decision
  std::vector<bool> has_guard_;         // [decisions]: some guard or table stands for it
  std::vector<bool> follows_;           // [decisions]: some guard does what it does, each time
  // [decisions][blocks of the PTX]: 1 + the way of the decision that goes to the block, where a decision
  // before it, folded into its guard, can go there as well and so pass it by; else 0.
  std::vector<std::vector<std::uint8_t>> folded_;
  const BlockIndex* begin_ = nullptr;  // of the trace
  const BlockIndex* trace_ = nullptr;  // what has not been used yet; never beyond its end
  // The entries of the trace that stand for a decision, in order, and the end.
  std::vector<std::uint32_t> decided_ = std::vector<std::uint32_t>(1024);
  const std::uint32_t* next_decided_ = nullptr;  // none before it is of what has not been used
  std::vector<std::int64_t> trips_left_;         // [loops]
  std::vector<std::uint32_t> returns_;           // nodes of calls that have not come back
  bool fits_ = true;
  RecordedPaths paths_;
  std::vector<std::uint32_t> record_of_;       // [nodes], no_record for all but those of paths
  DivisionPath path_ = DivisionPath::in_line;  // of the division that the lane is at
};

}  // namespace warpgrain::profiler::sass
