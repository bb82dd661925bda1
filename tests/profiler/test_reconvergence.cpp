#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "profiler/reconvergence.hpp"
#include "tests/profiler/hand_made.hpp"

namespace warpgrain::profiler {
namespace {

using testing::ElementsAre;

TEST(Reconvergence, IfElseJoinsBehind) {
  const Reconvergence r = find_reconvergence(hand_made_graph({{1, 2}, {3}, {3}, {}}));
  EXPECT_THAT(r.join, ElementsAre(false, false, false, true));
  EXPECT_THAT(r.immediate_post_dominator, ElementsAre(3, 3, 3, no_block));
  EXPECT_THAT(r.rank, ElementsAre(0, 2, 1, 3));
}

TEST(Reconvergence, BreakDoesNotHideTheJoinInsideTheLoop) {
  // for (;;) { 1: if (last) break; 2: if (a) 3; 4: if (b) break; } 5.  The `break` in 4 leaves from inside
  // the body.
  const KernelGraph graph = hand_made_graph({{1}, {5, 2}, {4, 3}, {4}, {5, 1}, {}});
  const Reconvergence r = find_reconvergence(graph);
  EXPECT_THAT(r.join, ElementsAre(false, true, true, false, true, true));
}

TEST(Reconvergence, ContinueJoinsAtTheHeaderAndBreakInsideAnIfKeepsTheIfsJoin) {
  // 1: header, if (last) break to 6; 2: if (a) { 3: if (b) break; (falls to 5) } else { 4: if (c) continue; }
  // 5: -> 1
  const KernelGraph graph = hand_made_graph({{1}, {6, 2}, {4, 3}, {6, 5}, {1, 5}, {1}, {}});
  const Reconvergence r = find_reconvergence(graph);
  // 3's only way that stays in the loop is 5, so 5 joins; over the whole graph nothing inside the loop would.
  EXPECT_TRUE(r.join[5]);
  EXPECT_TRUE(r.join[1]);
  EXPECT_TRUE(r.join[6]);
  EXPECT_FALSE(r.join[3]);
  EXPECT_FALSE(r.join[4]);
  EXPECT_EQ(r.immediate_post_dominator[3], 6U);
}

TEST(Reconvergence, SharedTargetOfAShortCircuitIsNoJoin) {
  // if (a && b) 2 else 3: 0 -> 3 | 1, 1 -> 3 | 2, both to 4. Block 3 is entered from two branches, and
  // post-dominates neither.
  const Reconvergence r = find_reconvergence(hand_made_graph({{3, 1}, {3, 2}, {4}, {4}, {}}));
  EXPECT_THAT(r.join, ElementsAre(false, false, false, false, true));
}

}  // namespace
}  // namespace warpgrain::profiler
