#include <gtest/gtest.h>
#include <initializer_list>

#include "profiler/sass/warp_groups.hpp"

namespace warpgrain::profiler::sass {
namespace {

// Block 0: the entry; 1: a BSYNC of B0; 2: a YIELD; 3: a WARPSYNC; 4: EXIT. Each goes on with the next.
CodeGraph some_code() {
  CodeGraph code;
  for (const End end : {End::next, End::meet, End::yield, End::warp_meet, End::exit}) {
    CodeBlock block;
    block.end = end;
    block.next = static_cast<std::uint32_t>(code.blocks.size() + 1);
    code.blocks.push_back(block);
  }
  return code;
}

class WarpGroupsTest : public testing::Test {
 protected:
  // The warp's lanes part into these groups, the last of which runs first. B0 is open for `barrier`.
  void part(Mask barrier, std::initializer_list<Mask> groups) {
    Mask all = 0;
    for (const Mask lanes : groups) all |= lanes;
    groups_.begin(all);
    WarpGroup whole;
    ASSERT_TRUE(groups_.next(whole));
    if (barrier != 0) groups_.act({Flow::open, 0, 0, MaskAction::Lanes::all}, barrier);
    for (const Mask lanes : groups)
      groups_.add(
          {lanes, 0, no_frame, groups_.partings().part(whole.node, 0, all & ~lanes, groups_.new_parting())});
    groups_.partings().release(whole.node);
  }

  WarpGroup next_at(std::uint32_t block) {
    WarpGroup group;
    EXPECT_TRUE(groups_.next(group));
    group.block = block;
    return group;
  }

  bool meet(const WarpGroup& group) { return groups_.meet(group, 0); }
  // YIELD leaves a group behind its block.
  bool yield(WarpGroup group) {
    group.block = 3;
    return groups_.yield(group);
  }

  CodeGraph code_ = some_code();
  ReplayCounters counters_{code_, ReplayPlan{}, KernelGraph{}};
  WarpGroups groups_{code_, counters_};
};

TEST_F(WarpGroupsTest, MeetingsJoin) {
  part(0b1111, {0b0011, 0b1100});
  EXPECT_FALSE(meet(next_at(1)));
  EXPECT_FALSE(meet(next_at(1)));
  WarpGroup group;
  ASSERT_TRUE(groups_.next(group));
  EXPECT_EQ(group.lanes, 0b1111U);
  EXPECT_EQ(group.block, 2U);
}

TEST_F(WarpGroupsTest, LanesThatLeaveOrEndAreNotWaitedFor) {
  part(0b1111, {0b1000, 0b0100, 0b0011});
  EXPECT_FALSE(meet(next_at(1)));
  const WarpGroup leaves = next_at(0);
  groups_.leave(0, leaves.lanes);
  groups_.end_leaving();
  groups_.end(next_at(4));
  WarpGroup group;
  ASSERT_TRUE(groups_.next(group));
  EXPECT_EQ(group.lanes, 0b0011U);
  EXPECT_EQ(group.block, 2U);
}

TEST_F(WarpGroupsTest, NobodyWaitsForLanesThatHaveYielded) {
  part(0b1111, {0b0011, 0b1100});
  EXPECT_TRUE(yield(next_at(2)));
  EXPECT_TRUE(meet(next_at(1))) << "0011 goes on alone";
  const WarpGroup late = next_at(1);
  EXPECT_EQ(late.lanes, 0b1100U);
  EXPECT_TRUE(meet(late)) << "the barrier has been emptied";
}

TEST_F(WarpGroupsTest, ThoseThatWaitAlreadyStayUntilOneComes) {
  part(0b1111, {0b1100, 0b0011});
  EXPECT_FALSE(meet(next_at(1)));
  EXPECT_TRUE(yield(next_at(2)));
  const WarpGroup resumed = next_at(1);
  EXPECT_EQ(resumed.lanes, 0b1100U);
  EXPECT_FALSE(meet(resumed));
  EXPECT_EQ(next_at(0).lanes, 0b1111U);
}

TEST_F(WarpGroupsTest, GroupsThatHaveYieldedAtOnePlaceRunOnTogether) {
  part(0, {0b0001, 0b0010, 0b1100});
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(yield(next_at(2)));
  WarpGroup group;
  ASSERT_TRUE(groups_.next(group));
  EXPECT_EQ(group.lanes, 0b1111U);
  EXPECT_EQ(group.block, 3U);
  EXPECT_FALSE(groups_.yield(group)) << "there is no other";
}

TEST_F(WarpGroupsTest, LanesThatTheBarrierDoesNotKnowGoOnApart) {
  part(0b0111, {0b0001, 0b1110});
  EXPECT_FALSE(meet(next_at(1)));
  EXPECT_FALSE(meet(next_at(1)));
  EXPECT_EQ(next_at(0).lanes, 0b0111U);
  EXPECT_EQ(next_at(0).lanes, 0b1000U);
}

TEST_F(WarpGroupsTest, FunctionsPutABarrierAside) {
  part(0b1111, {0b0011, 0b1100});
  const WarpGroup inside = next_at(1);
  groups_.act({Flow::save, 0, 0, MaskAction::Lanes::all}, inside.lanes);
  groups_.act({Flow::open, 0, 0, MaskAction::Lanes::all}, inside.lanes);
  EXPECT_TRUE(meet(inside)) << "the function's own meeting";
  groups_.act({Flow::restore, 0, 0, MaskAction::Lanes::all}, inside.lanes);
  EXPECT_FALSE(meet(inside)) << "the caller's";
  EXPECT_FALSE(meet(next_at(1)));
  EXPECT_EQ(next_at(0).lanes, 0b1111U);
}

TEST_F(WarpGroupsTest, WarpMeetingsTakeAll) {
  part(0, {0b0011, 0b1100});
  EXPECT_FALSE(groups_.meet_warp(next_at(3)));
  EXPECT_FALSE(groups_.meet_warp(next_at(3)));
  const WarpGroup all = next_at(3);
  EXPECT_EQ(all.lanes, 0b1111U);
  EXPECT_TRUE(groups_.meet_warp(all));
}

}  // namespace
}  // namespace warpgrain::profiler::sass
