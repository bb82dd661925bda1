#pragma once
// A lane's way through the machine code, from its trace.

#include <cstdint>
#include <vector>

#include "profiler/sass/recorded_paths.hpp"
#include "profiler/sass/replay_counters.hpp"
#include "profiler/sass/replay_plan.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler::sass {

// What a lane chose at each node of its way, in order: at guards whose rule is decision, trips or unknown 1
// if it took the guard, else 0; at indirect branches the entry of the table. Other nodes leave no choice.
struct Choice {
  std::uint16_t way = 0;
  std::uint32_t entries = 0;  // of the trace that the lane has left behind then
};
using Choices = std::vector<Choice>;

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

  void choose(std::uint32_t way, Choices& choices) const;
  void note_folded(const PtxDecisions& decisions);
  bool take_decision(const Node& node);
  bool take_trips(const Node& node);
  std::uint32_t take_indirect(const Node& node);
  void pass(const Way& way);
  std::int64_t count_trips(const TripLoop& loop) const;
  std::uint32_t index_of(const Node& node) const;

  const ReplayPlan& plan_;
  ReplayCounters& counters_;
  std::vector<Run> runs_;               // [blocks of the PTX]
  std::vector<std::uint32_t> run_end_;  // [blocks of the PTX]: the block with the decision
  std::vector<bool> has_guard_;         // [decisions]: some guard or table stands for it
  std::vector<bool> follows_;           // [decisions]: some guard does what it does, each time
  // [decisions][blocks of the PTX]: 1 + the way of the decision that goes to the block, where a decision
  // before it, folded into its guard, can go there as well and so pass it by; else 0.
  std::vector<std::vector<std::uint8_t>> folded_;
  const BlockIndex* begin_ = nullptr;     // of the trace
  const BlockIndex* trace_ = nullptr;     // what has not been used yet; never beyond its end
  std::vector<std::int64_t> trips_left_;  // [loops]
  std::vector<std::uint32_t> returns_;    // nodes of calls that have not come back
  bool fits_ = true;
  RecordedPaths paths_;
  std::vector<std::uint32_t> record_of_;       // [nodes], no_record for all but those of paths
  DivisionPath path_ = DivisionPath::in_line;  // of the division that the lane is at
};

}  // namespace warpgrain::profiler::sass
