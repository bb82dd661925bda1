// Pools whose bound a reader can count.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "profiler/formation_bound.hpp"
#include "tests/profiler/hand_made.hpp"

namespace warpgrain::profiler {
namespace {

using testing::ElementsAre;

TEST(FormationBound, RegroupsThreadsThatGoOneWay) {
  // 12 threads in warps of 4; every third goes by block 1, the others by block 2.
  const KernelGraph graph = hand_made_graph({{1, 2}, {3}, {3}, {}});
  HandMadeTraces traces;
  for (std::uint32_t thread = 0; thread < 12; ++thread)
    traces.add_lane(graph, {0, thread % 3 == 0 ? 1U : 2U, 3});
  FormationBound bound(graph, {{4, 4}, {8, 4}, {16, 4}});
  bound.add(0, traces.lanes());
  bound.end_pools();
  // Of four threads one or two go by block 1, so each pool issues all blocks once: three times.
  EXPECT_THAT(bound.counts()[0].issues, ElementsAre(3, 3, 3, 3));
  // Threads 0 to 7: three by block 1 (0, 3, 6), five by block 2; 8 to 11: one (9) and three.
  EXPECT_THAT(bound.counts()[1].issues, ElementsAre(3, 2, 2 + 1, 3));
  // All twelve: four and eight.
  EXPECT_THAT(bound.counts()[2].issues, ElementsAre(3, 1, 2, 3));
  EXPECT_THAT(bound.counts()[2].executions, ElementsAre(12, 4, 8, 12));
  EXPECT_EQ(bound.counts()[1].pools, 2U);
}

TEST(FormationBound, ALongThreadIsNeverIssuedTwiceAtOnce) {
  // One of four threads goes ten times through the loop, the others once: 13 rounds in all, but ten issues.
  const KernelGraph graph = hand_made_graph({{1}, {1, 2}, {}});
  HandMadeTraces traces;
  for (std::uint32_t thread = 0; thread < 4; ++thread) {
    std::vector<std::uint32_t> path(thread == 2 ? 12 : 3, 1);
    path.front() = 0;
    path.back() = 2;
    traces.add_lane(graph, path);
  }
  FormationBound bound(graph, {{4, 4}});
  bound.add(0, traces.lanes());
  bound.end_pools();
  EXPECT_THAT(bound.counts()[0].issues, ElementsAre(1, 10, 1));
  EXPECT_THAT(bound.counts()[0].executions, ElementsAre(4, 13, 4));
}

TEST(FormationBound, PoolsGoOnFromCallToCallAndMissingThreadsCountNowhere) {
  const KernelGraph graph = hand_made_graph({{}});
  HandMadeTraces three;
  three.add_lane(graph, {0});
  three.add_missing_lane();
  three.add_lane(graph, {0});
  FormationBound bound(graph, {{8, 4}}), rest(graph, {{8, 4}});
  bound.add(0, three.lanes());
  bound.add(3, three.lanes());  // threads 0 to 5 of the first pool: four exist
  bound.add(8, three.lanes());
  bound.end_pools();
  EXPECT_THAT(bound.counts()[0].issues, ElementsAre(1 + 1));
  EXPECT_EQ(bound.counts()[0].pools, 2U);
  rest.add(16, three.lanes());
  rest.end_pools();
  bound.add_counts(rest);
  EXPECT_THAT(bound.counts()[0].issues, ElementsAre(3));
  EXPECT_THAT(bound.counts()[0].executions, ElementsAre(8));
}

}  // namespace
}  // namespace warpgrain::profiler
