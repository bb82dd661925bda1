#pragma once
// The groups of a warp whose lanes run together: which runs next, which wait, where they become one again.
//
// Rules of the machine that NVIDIA does not document, found from which lanes an H100 runs together in kernels
// of known control flow, and from its counts of them (docs/exactness.md, "How the rules were found"):
// * Of the sides of a branch the one with fewer lanes runs first, at a tie the one that goes straight on. The
//   other is put off: it runs, alone, when the first cannot go on. Only one group at a time is so; a branch
//   meanwhile puts off its own side instead, and the earlier one is left among those that stand somewhere.
// * When the running group waits or ends and none is put off, one of the places where lanes stand is chosen,
//   that with the fewest lanes, at a tie the lower address: all lanes at that place run on as one, also those
//   that came there another way, and those that wait at it. So a BSYNC is issued again by lanes that wait.
// * A BSYNC holds lanes until those of its barrier have all come, ended, left with BREAK or yielded. Those
//   that the barrier does not know pass. Lanes that others let go (BREAK, EXIT) issue the BSYNC again; where
//   BREAK lets fewer lanes go than have left, these run first.
// * YIELD lets others run. Lanes that have yielded run when no others can, those at one place as one. Turns
//   go round by lane, from lane 0 past each lane that a YIELD has let run. This rule is known in part: it
//   gives the order of most kernels with a YIELD that were tried, not of all. Where it decides, the
//   counters count it (`turns_assumed`).
// Lanes run on as one only within one call.

#include <cstdint>
#include <optional>
#include <vector>

#include "profiler/partings.hpp"
#include "profiler/sass/code_graph.hpp"
#include "profiler/sass/convergence_barriers.hpp"
#include "profiler/sass/lane_mask.hpp"
#include "profiler/sass/replay_counters.hpp"

namespace warpgrain::profiler::sass {

inline constexpr std::uint32_t no_frame = 0xFFFFFFFF;

// Where in its block a group stands.
enum class Stand : std::uint8_t {
  begin,
  left,     // at its begin, but the BREAKs of the block are done
  decided,  // before its last instruction, all before which is done
  table     // the same, at an indirect branch that some lanes have taken
};

struct WarpGroup {
  Mask lanes = 0;
  std::uint32_t block = 0;         // of the code
  std::uint32_t frame = no_frame;  // the call that it is in
  Partings::Node node = 0;
  Stand stand = Stand::begin;
};

// Of one warp at a time. All outlive it.
class WarpGroups {
 public:
  WarpGroups(const CodeGraph& code, ReplayCounters& counters);

  // A warp's first group, at the entry. The last warp's have all ended.
  void begin(Mask lanes);
  // Takes out the group to run next. False when all lanes have ended.
  bool next(WarpGroup& group);
  // Forgets the groups of a warp that cannot be followed.
  void give_up();

  Mask alive() const { return alive_; }
  Partings& partings() { return partings_; }
  std::uint64_t new_parting() { return ++n_partings_; }
  // The side of a branch that runs later.
  void put_off(const WarpGroup& group);
  void end(const WarpGroup& group);

  // What a block does to barriers before its last instruction, without BREAK.
  void act(const MaskAction& action, Mask lanes);
  void leave(std::uint8_t barrier, Mask lanes);
  // Whether others run first, whom these let go when they left; then the group is put off.
  bool gives_way(const WarpGroup& group);

  // Whether the group, joined by those that wait there, goes through the meeting at its block now; else it
  // waits.
  bool meet(WarpGroup& group, std::uint8_t barrier);
  bool meet_warp(WarpGroup& group);
  // Whether there are others to let run first.
  bool yield(const WarpGroup& group);

 private:
  bool is_known(const WarpGroup& group, std::uint8_t barrier) const;
  Mask missing_at(const WarpGroup& group, std::uint8_t barrier) const;
  bool can_pass(const WarpGroup& group) const;
  bool choose(WarpGroup& group, const WarpGroup* yields);
  bool choose_place(WarpGroup& group);
  bool choose_yielded(WarpGroup& group, const WarpGroup* yields);
  void pass_lanes(const WarpGroup& chosen);
  void join_those_at(std::vector<WarpGroup>& groups, WarpGroup& group);
  void force(WarpGroup& group);

  const CodeGraph& code_;
  ReplayCounters& counters_;
  Partings partings_;
  std::uint64_t n_partings_ = 0;
  Mask alive_ = 0, yielded_lanes_ = 0;
  std::uint32_t next_lane_ = 0;       // to look at first among those that have yielded
  std::optional<WarpGroup> turn_;     // whose turn it is before all others
  std::optional<WarpGroup> put_off_;  // by the last branch
  std::vector<WarpGroup> standing_;   // can run
  std::vector<WarpGroup> waiting_;    // at the meeting of their block
  std::vector<WarpGroup> yielded_;    // first who yielded first
  ConvergenceBarriers barriers_;
};

}  // namespace warpgrain::profiler::sass
