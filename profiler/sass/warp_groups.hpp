#pragma once
// The groups of a warp whose lanes run together: which runs next, which wait, where they become one again.
//
// Rules of the machine that NVIDIA does not document, found from an H100's counts (docs/exactness.md):
// * Of the sides of a branch the smaller one runs first, the one that goes on straight when they are equal;
//   at a branch back, those that jump.
// * A BSYNC holds a group until the lanes of its barrier have all come, ended, left with BREAK or yielded.
//   Those that the barrier does not know pass.
// * YIELD puts a group aside until every other waits or has yielded; then those that stand at one place
//   run on as one. What waits is looked at when a group comes to a BSYNC, not when one yields. This rule,
//   and that of branches back, are fitted to the one launch of the 62 whose code has a YIELD (forces in
//   fp64), of whose counts they leave up to 5 %: another kernel may show them wrong.

#include <cstdint>
#include <vector>

#include "profiler/partings.hpp"
#include "profiler/sass/code_graph.hpp"
#include "profiler/sass/convergence_barriers.hpp"
#include "profiler/sass/lane_mask.hpp"
#include "profiler/sass/replay_counters.hpp"

namespace warpgrain::profiler::sass {

inline constexpr std::uint32_t no_frame = 0xFFFFFFFF;

struct WarpGroup {
  Mask lanes = 0;
  std::uint32_t block = 0;         // of the code
  std::uint32_t frame = no_frame;  // the call that it is in
  Partings::Node node = 0;
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
  // A group that can run: before all that were added.
  void add(const WarpGroup& group) { ready_.push_back(group); }
  void end(const WarpGroup& group);

  // What a block does to barriers before its last instruction.
  void act(const MaskAction& action, Mask lanes);
  void leave(std::uint8_t barrier, Mask lanes);
  // Lets those go on whom lanes that left kept waiting.
  void end_leaving();

  // Whether the group goes through the meeting at its block now; else it waits.
  bool meet(const WarpGroup& group, std::uint8_t barrier);
  bool meet_warp(const WarpGroup& group);
  // Whether there are others to let run first.
  bool yield(const WarpGroup& group);

  // The last instruction of a block is issued once more.
  void issue_again(const WarpGroup& group, std::uint32_t block);

 private:
  Mask expected(const WarpGroup& group, std::uint8_t barrier) const;
  bool waits_at(const WarpGroup& other, const WarpGroup& group, std::uint8_t barrier) const;
  bool comes_alone(const WarpGroup& group, std::uint8_t barrier);
  bool resume();
  bool release_any();
  void release(const WarpGroup& first, Mask lanes);
  void force_release();

  const CodeGraph& code_;
  ReplayCounters& counters_;
  Partings partings_;
  std::uint64_t n_partings_ = 0;
  Mask alive_ = 0, yielded_lanes_ = 0;
  bool left_ = false;                                 // lanes have just left a barrier's mask
  std::vector<WarpGroup> ready_, waiting_, yielded_;  // groups that wait stand at the block where they do
  ConvergenceBarriers barriers_;
};

}  // namespace warpgrain::profiler::sass
