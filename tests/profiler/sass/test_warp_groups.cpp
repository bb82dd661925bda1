#include <gtest/gtest.h>

#include "profiler/sass/warp_groups.hpp"

namespace warpgrain::profiler::sass {
namespace {

// Block 0: the entry; 1: a BSYNC of B0; 2: a YIELD; 3: a WARPSYNC; 4: EXIT; 5: a BSYNC of B1. Each goes on
// with the next.
CodeGraph some_code() {
  CodeGraph code;
  for (const End end : {End::next, End::meet, End::yield, End::warp_meet, End::exit, End::meet}) {
    CodeBlock block;
    block.end = end;
    block.next = static_cast<std::uint32_t>(code.blocks.size() + 1);
    code.blocks.push_back(block);
  }
  code.blocks[5].barrier = 1;
  return code;
}

class WarpGroupsTest : public testing::Test {
 protected:
  // The warp, at its entry. B0 is open for `barrier`.
  WarpGroup begin(Mask lanes, Mask barrier) {
    groups_.begin(lanes);
    open(0, barrier);
    return next();
  }
  void open(std::uint8_t barrier, Mask lanes) {
    if (lanes != 0) groups_.act({Flow::open, barrier, 0, MaskAction::Lanes::all}, lanes);
  }
  WarpGroup next() {
    WarpGroup group;
    EXPECT_TRUE(groups_.next(group));
    return group;
  }
  static WarpGroup at(std::uint32_t block, WarpGroup group) {
    group.block = block;
    return group;
  }
  // `later` leave the group and are put off, at that block; what remains runs.
  WarpGroup part(const WarpGroup& group, Mask later, std::uint32_t block) {
    const std::uint64_t parting = groups_.new_parting();
    Partings& partings = groups_.partings();
    const Mask first = group.lanes & ~later;
    groups_.put_off({later, block, no_frame, partings.part(group.node, 0, first, parting)});
    const WarpGroup runs{first, group.block, no_frame, partings.part(group.node, 0, later, parting)};
    partings.release(group.node);
    return runs;
  }
  bool meet(WarpGroup group) {
    group.block = 1;
    return groups_.meet(group, 0);
  }
  // YIELD leaves a group behind its block.
  bool yield(const WarpGroup& group, std::uint32_t behind = 3) { return groups_.yield(at(behind, group)); }

  CodeGraph code_ = some_code();
  ReplayCounters counters_{code_, ReplayPlan{}, KernelGraph{}};
  WarpGroups groups_{code_, counters_};
};

TEST_F(WarpGroupsTest, MeetingsJoin) {
  EXPECT_FALSE(meet(part(begin(0b1111, 0b1111), 0b0011, 0)));
  WarpGroup last = at(1, next());
  EXPECT_EQ(last.lanes, 0b0011U);
  EXPECT_TRUE(groups_.meet(last, 0));
  EXPECT_EQ(last.lanes, 0b1111U);
}

TEST_F(WarpGroupsTest, TheSidePutOffLastRunsNext) {
  WarpGroup runs = part(begin(0b1111, 0), 0b1000, 2);
  runs = part(runs, 0b0100, 3);
  groups_.end(runs);
  WarpGroup group = next();
  EXPECT_EQ(group.lanes, 0b0100U);
  groups_.end(group);
  group = next();
  EXPECT_EQ(group.lanes, 0b1000U);
  EXPECT_EQ(group.block, 2U);
}

TEST_F(WarpGroupsTest, OfPlacesThatWithTheFewestLanesRunsAsOne) {
  WarpGroup runs = part(begin(0xFF, 0), 0b11100000, 3);
  runs = part(runs, 0b00010000, 4);
  runs = part(runs, 0b00001000, 4);
  runs = part(runs, 0b00000100, 2);
  groups_.end(runs);
  groups_.end(next());
  const WarpGroup chosen = next();
  EXPECT_EQ(chosen.lanes, 0b00011000U) << "at one place by chance";
  EXPECT_EQ(chosen.block, 4U);
  groups_.end(chosen);
  EXPECT_EQ(next().lanes, 0b11100000U);
}

TEST_F(WarpGroupsTest, LanesThatWaitAtAPlaceIssueItAgainWithThoseThatStandThere) {
  // As `if (a) { if (b) x; else y; }`: the lanes without a stand at the BSYNC from the beginning.
  WarpGroup runs = part(begin(0xFF, 0xFF), 0xF0, 1);
  runs = part(runs, 0b1100, 0);
  EXPECT_FALSE(meet(runs));
  EXPECT_FALSE(meet(next()));
  WarpGroup last = next();
  EXPECT_EQ(last.lanes, 0xFFU) << "all are active when the last ones issue it";
  EXPECT_TRUE(groups_.meet(last, 0));
}

TEST_F(WarpGroupsTest, LanesThatEndAreNotWaitedFor) {
  EXPECT_FALSE(meet(part(begin(0b1111, 0b1111), 0b0100, 4)));
  groups_.end(next());
  WarpGroup released = next();
  EXPECT_EQ(released.lanes, 0b1011U);
  EXPECT_EQ(released.block, 1U) << "they issue the BSYNC again";
  EXPECT_TRUE(groups_.meet(released, 0));
}

TEST_F(WarpGroupsTest, FewerThatBreakLetsGoRunFirst) {
  EXPECT_FALSE(meet(part(begin(0b1111, 0b1111), 0b1110, 2)));
  const WarpGroup leaves = next();
  groups_.leave(0, leaves.lanes);
  EXPECT_TRUE(groups_.gives_way(leaves));
  const WarpGroup released = next();
  EXPECT_EQ(released.lanes, 0b0001U);
  groups_.end(released);
  EXPECT_EQ(next().lanes, 0b1110U);
}

TEST_F(WarpGroupsTest, AsManyThatBreakLetsGoRunLater) {
  EXPECT_FALSE(meet(part(begin(0b1111, 0b1111), 0b1100, 2)));
  const WarpGroup leaves = next();
  groups_.leave(0, leaves.lanes);
  EXPECT_FALSE(groups_.gives_way(leaves));
  groups_.end(leaves);
  EXPECT_EQ(next().lanes, 0b0011U);
}

TEST_F(WarpGroupsTest, NobodyWaitsForLanesThatHaveYielded) {
  EXPECT_TRUE(yield(part(begin(0b1111, 0b1111), 0b0011, 0)));
  EXPECT_EQ(counters_.turns_assumed, 1U);
  const WarpGroup other = next();
  EXPECT_EQ(other.lanes, 0b0011U);
  EXPECT_TRUE(meet(other)) << "0011 goes on alone";
  groups_.end(other);
  const WarpGroup late = next();
  EXPECT_EQ(late.lanes, 0b1100U);
  EXPECT_TRUE(meet(late)) << "the barrier has been emptied";
}

TEST_F(WarpGroupsTest, GroupsThatHaveYieldedAtOnePlaceRunOnTogether) {
  WarpGroup runs = part(begin(0b1111, 0), 0b1100, 0);
  runs = part(runs, 0b0010, 0);
  EXPECT_TRUE(yield(runs));
  EXPECT_TRUE(yield(next()));
  EXPECT_TRUE(yield(next()));
  const WarpGroup group = next();
  EXPECT_EQ(group.lanes, 0b1111U) << "with those that yield just then";
  EXPECT_EQ(group.block, 3U);
  EXPECT_FALSE(yield(group)) << "there is no other";
}

TEST_F(WarpGroupsTest, ThoseThatHaveYieldedTakeTurnsLaneByLane) {
  // Lanes 0 and 3 stand apart from 1 and 2, and all yield again and again.
  WarpGroup runs = part(begin(0b1111, 0), 0b0110, 0);
  EXPECT_TRUE(yield(runs, 3));
  EXPECT_TRUE(yield(next(), 2));
  for (const Mask lanes : {0b1001U, 0b0110U, 0b1001U, 0b0110U}) {
    const WarpGroup turn = next();
    EXPECT_EQ(turn.lanes, lanes);
    EXPECT_TRUE(yield(turn, turn.block));
  }
}

TEST_F(WarpGroupsTest, LanesThatTheBarrierDoesNotKnowPass) {
  EXPECT_TRUE(meet(part(begin(0b1111, 0b0011), 0b0011, 0))) << "1100, for which nobody waits";
}

TEST_F(WarpGroupsTest, FunctionsPutABarrierAside) {
  const WarpGroup inside = part(begin(0b1111, 0b1111), 0b1100, 0);
  groups_.act({Flow::save, 0, 0, MaskAction::Lanes::all}, inside.lanes);
  open(0, inside.lanes);
  EXPECT_TRUE(meet(inside)) << "the function's own meeting";
  groups_.act({Flow::restore, 0, 0, MaskAction::Lanes::all}, inside.lanes);
  EXPECT_FALSE(meet(inside)) << "the caller's";
  EXPECT_TRUE(meet(next()));
}

TEST_F(WarpGroupsTest, WarpMeetingsTakeAll) {
  WarpGroup first = at(3, part(begin(0b1111, 0), 0b1100, 0));
  EXPECT_FALSE(groups_.meet_warp(first));
  WarpGroup last = at(3, next());
  EXPECT_TRUE(groups_.meet_warp(last));
  EXPECT_EQ(last.lanes, 0b1111U);
}

}  // namespace
}  // namespace warpgrain::profiler::sass
