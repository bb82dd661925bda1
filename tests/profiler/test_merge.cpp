#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <stdexcept>

#include "profiler/merge.hpp"
#include "profiler/observers/totals.hpp"
#include "tests/profiler/hand_made.hpp"

namespace warpgrain::profiler {
namespace {

using testing::Each;
using testing::ElementsAre;

// Merges one warp the fast way, after a check that the plain way gives the same.
WarpCounters merged(const KernelGraph& graph, const HandMadeTraces& traces, std::uint32_t width,
                    MergePolicy policy = MergePolicy::loop_postdom) {
  WarpCounters counters(graph, width), plain(graph, width);
  make_counting_merger(graph, policy, counters)->merge(traces.lanes());
  WarpCounterObserver observer(graph, plain);
  make_observed_merger(graph, policy, width, observer)->merge(traces.lanes());
  EXPECT_EQ(counters.block_executions, plain.block_executions);
  EXPECT_EQ(counters.divergent, plain.divergent);
  EXPECT_EQ(counters.taken_lanes, plain.taken_lanes);
  EXPECT_EQ(counters.lane_slots_lost, plain.lane_slots_lost);
  EXPECT_EQ(counters.accesses, plain.accesses);
  EXPECT_EQ(counters.warps, plain.warps);
  return counters;
}

// Executions of a block as {lanes, times} pairs, by lanes.
std::vector<std::pair<std::uint64_t, std::uint64_t>> runs(const WarpCounters& counters, std::uint32_t block) {
  std::vector<std::pair<std::uint64_t, std::uint64_t>> result;
  const auto executions = counters.executions(block);
  for (std::size_t lanes = 0; lanes < executions.size(); ++lanes)
    if (executions[lanes] != 0) result.emplace_back(lanes, executions[lanes]);
  return result;
}

using Runs = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

void expect_all_lane_slots_accounted(const KernelGraph& graph, const WarpCounters& counters) {
  const Totals totals = launch_totals(graph, counters);
  const std::uint64_t lost =
      std::accumulate(counters.lane_slots_lost.begin(), counters.lane_slots_lost.end(), std::uint64_t{0});
  EXPECT_EQ(lost, counters.warp_width * totals.warp_instructions - totals.thread_instructions);
}

class EveryPolicy : public testing::TestWithParam<MergePolicy> {};
INSTANTIATE_TEST_SUITE_P(Merge, EveryPolicy,
                         testing::Values(MergePolicy::loop_postdom, MergePolicy::ipdom, MergePolicy::min_pc),
                         [](const auto& tested) { return std::string(merge_policy_name(tested.param)); });

TEST_P(EveryPolicy, HalfAndHalf) {
  const KernelGraph graph = hand_made_graph({{1, 2}, {3}, {3}, {}}, {5, 7, 11, 3});
  HandMadeTraces traces;
  for (std::uint32_t lane = 0; lane < 32; ++lane) traces.add_lane(graph, {0, lane < 16 ? 1U : 2U, 3});
  const WarpCounters counters = merged(graph, traces, 32, GetParam());
  EXPECT_EQ(runs(counters, 0), (Runs{{32, 1}}));
  EXPECT_EQ(runs(counters, 1), (Runs{{16, 1}}));
  EXPECT_EQ(runs(counters, 2), (Runs{{16, 1}}));
  EXPECT_EQ(runs(counters, 3), (Runs{{32, 1}}));
  EXPECT_THAT(counters.divergent, ElementsAre(1, 0, 0, 0));
  EXPECT_THAT(counters.taken_lanes, ElementsAre(16, 0, 0, 0));
  EXPECT_THAT(counters.lane_slots_lost, ElementsAre(16 * (7 + 11), 0, 0, 0, 0));
}

TEST_P(EveryPolicy, TripCountIsTheLane) {
  const KernelGraph graph = hand_made_graph({{1}, {1, 2}, {}}, {2, 10, 3});
  HandMadeTraces traces;
  for (std::uint32_t lane = 0; lane < 32; ++lane) {
    std::vector<std::uint32_t> path(lane + 2, 1);  // lane + 1 rounds
    path.front() = 0;
    path.push_back(2);
    traces.add_lane(graph, path);
  }
  const WarpCounters counters = merged(graph, traces, 32, GetParam());
  Runs every_count_once;
  for (std::uint64_t lanes = 1; lanes <= 32; ++lanes) every_count_once.emplace_back(lanes, 1);
  EXPECT_EQ(runs(counters, 1), every_count_once);
  EXPECT_EQ(runs(counters, 2), (Runs{{32, 1}}));
  EXPECT_EQ(counters.divergent[1], 31U);
  EXPECT_EQ(counters.taken_lanes[1], 31U * 32 / 2);
  EXPECT_EQ(counters.lane_slots_lost[1], 10U * 31 * 32 / 2);
}

TEST_P(EveryPolicy, FiveNestedBranchesMakeThirtyTwoLeaves) {
  // Node n of a binary tree in heap order goes to 2n+1 or 2n+2; 31 inner nodes, 32 leaves, which all lead
  // to 63.
  SuccessorLists successors(64);
  for (std::uint32_t n = 0; n < 31; ++n) successors[n] = {2 * n + 1, 2 * n + 2};
  for (std::uint32_t leaf = 31; leaf < 63; ++leaf) successors[leaf] = {63};
  const KernelGraph graph = hand_made_graph(successors);
  HandMadeTraces traces;
  for (std::uint32_t lane = 0; lane < 32; ++lane) {
    std::vector<std::uint32_t> path{0};
    for (int bit = 4; bit >= 0; --bit) path.push_back(2 * path.back() + 1 + (lane >> bit & 1));
    path.push_back(63);
    traces.add_lane(graph, path);
  }
  const WarpCounters counters = merged(graph, traces, 32, GetParam());
  for (std::uint32_t leaf = 31; leaf < 63; ++leaf) EXPECT_EQ(runs(counters, leaf), (Runs{{1, 1}}));
  EXPECT_EQ(runs(counters, 63), (Runs{{32, 1}}));
  // The root's branch idles 16 lanes over 62 nodes; one of level d idles 32 / 2^(d+1) over the nodes below
  // it.
  EXPECT_EQ(counters.lane_slots_lost[0], 16U * 62);
  EXPECT_EQ(counters.lane_slots_lost[1], 8U * 30);
  EXPECT_EQ(counters.lane_slots_lost[30], 1U * 2);
  expect_all_lane_slots_accounted(graph, counters);
}

TEST_P(EveryPolicy, EarlyReturnIdlesItsLanesToTheEnd) {
  const KernelGraph graph = hand_made_graph({{1, 2}, {}, {3}, {}}, {5, 2, 40, 60});
  HandMadeTraces traces;
  for (std::uint32_t lane = 0; lane < 32; ++lane) {
    if (lane % 4 == 0) {
      traces.add_lane(graph, {0, 1});
    } else {
      traces.add_lane(graph, {0, 2, 3});
    }
  }
  const WarpCounters counters = merged(graph, traces, 32, GetParam());
  EXPECT_EQ(runs(counters, 3), (Runs{{24, 1}}));
  EXPECT_EQ(counters.lane_slots_lost[0], 24U * 2 + 8U * (40 + 60));
}

// 1 is the loop's header and 4 its end; 2 continues, 3 breaks.
KernelGraph break_and_continue() {
  return hand_made_graph({{1}, {5, 2}, {4, 3}, {5, 4}, {1}, {}}, {1, 2, 3, 5, 7, 11});
}
HandMadeTraces break_and_continue_lanes(const KernelGraph& graph) {
  HandMadeTraces traces;
  traces.add_lane(graph, {0, 1, 2, 4, 1, 2, 3, 4, 1, 5});     // continues in the first round
  traces.add_lane(graph, {0, 1, 2, 3, 4, 1, 2, 3, 4, 1, 5});  // two whole rounds
  traces.add_lane(graph, {0, 1, 2, 3, 5});                    // breaks in the first round
  traces.add_lane(graph, {0, 1, 2, 3, 4, 1, 2, 3, 5});        // breaks in the second round
  return traces;
}

TEST(Merge, BreakAndContinueUnderLoopPostdom) {
  const KernelGraph graph = break_and_continue();
  const WarpCounters counters = merged(graph, break_and_continue_lanes(graph), 4);
  EXPECT_EQ(runs(counters, 1), (Runs{{2, 1}, {3, 1}, {4, 1}}));
  EXPECT_EQ(runs(counters, 2), (Runs{{3, 1}, {4, 1}}));
  EXPECT_EQ(runs(counters, 3), (Runs{{3, 2}}));
  EXPECT_EQ(runs(counters, 4), (Runs{{2, 1}, {3, 1}}));
  EXPECT_EQ(runs(counters, 5), (Runs{{4, 1}}));
  // Lane 0 waits once for block 3. Lane 2, and in the second round lane 3 too, wait for the rounds after
  // their break: blocks 4 1 2 3 without lane 2, then 4 1 without lanes 2 and 3.
  EXPECT_THAT(counters.lane_slots_lost, ElementsAre(0, 0, 5, (7 + 2 + 3 + 5) + 2 * (7 + 2), 0, 0, 0));
}

TEST(Merge, BreakAndContinueUnderIpdomRunsApart) {
  const KernelGraph graph = break_and_continue();
  const WarpCounters counters = merged(graph, break_and_continue_lanes(graph), 4, MergePolicy::ipdom);
  EXPECT_EQ(runs(counters, 1), (Runs{{1, 3}, {2, 1}, {4, 1}}));
  EXPECT_EQ(runs(counters, 2), (Runs{{1, 1}, {2, 1}, {4, 1}}));
  EXPECT_EQ(runs(counters, 3), (Runs{{1, 1}, {2, 1}, {3, 1}}));
  EXPECT_EQ(runs(counters, 4), (Runs{{1, 3}, {2, 1}}));
  EXPECT_EQ(runs(counters, 5), (Runs{{4, 1}}));
  expect_all_lane_slots_accounted(graph, counters);
}

TEST_P(EveryPolicy, SwitchRunsEachCaseOnce) {
  const KernelGraph graph = hand_made_graph({{1, 2, 3, 4}, {5}, {5}, {5}, {5}, {}}, {1, 10, 20, 30, 40, 1});
  HandMadeTraces traces;
  for (std::uint32_t lane = 0; lane < 32; ++lane) traces.add_lane(graph, {0, 1 + lane % 4, 5});
  const WarpCounters counters = merged(graph, traces, 32, GetParam());
  for (std::uint32_t block = 1; block <= 4; ++block) EXPECT_EQ(runs(counters, block), (Runs{{8, 1}}));
  EXPECT_THAT(counters.lane_slots_lost, ElementsAre(24 * 100, 0, 0, 0, 0, 0, 0));
  EXPECT_EQ(counters.divergent[0], 1U);
}

TEST(Merge, SharedTargetOfAShortCircuitRunsOncePerBranchUnlessGroupsJoinAnywhere) {
  const KernelGraph graph = hand_made_graph({{3, 1}, {3, 2}, {4}, {4}, {}});
  HandMadeTraces traces;
  traces.add_lane(graph, {0, 3, 4});
  traces.add_lane(graph, {0, 1, 3, 4});
  traces.add_lane(graph, {0, 1, 2, 4});
  traces.add_lane(graph, {0, 1, 2, 4});
  EXPECT_EQ(runs(merged(graph, traces, 4), 3), (Runs{{1, 2}}));
  EXPECT_EQ(runs(merged(graph, traces, 4, MergePolicy::min_pc), 3), (Runs{{2, 1}}));
}

TEST_P(EveryPolicy, LanesThatDoNotExistAreBlamedOnNoBranch) {
  const KernelGraph graph = hand_made_graph({{1, 2}, {3}, {3}, {}}, {5, 7, 11, 3});
  HandMadeTraces traces;
  traces.add_lane(graph, {0, 1, 3});
  traces.add_missing_lane();
  traces.add_lane(graph, {0, 2, 3});  // and lanes 3 to 7 are not even in the span
  const WarpCounters counters = merged(graph, traces, 8, GetParam());
  EXPECT_EQ(counters.warps, 1U);
  EXPECT_THAT(counters.lane_slots_lost, ElementsAre(7 + 11, 0, 0, 0, 6 * (5 + 7 + 11 + 3)));
}

TEST_P(EveryPolicy, AWarpWithoutLanesIsNone) {
  const KernelGraph graph = hand_made_graph({{}});
  HandMadeTraces traces;
  traces.add_missing_lane();
  const WarpCounters counters = merged(graph, traces, 4, GetParam());
  EXPECT_EQ(counters.warps, 0U);
  EXPECT_THAT(counters.block_executions, Each(0));
}

TEST_P(EveryPolicy, RequestsAreCountedPerAccessOfActiveLanes) {
  KernelGraph graph = hand_made_graph({{1, 2}, {2}, {}});
  add_access(graph, 0, InstructionClass::global_load, 4);
  add_access(graph, 1, InstructionClass::global_store, 8);
  HandMadeTraces traces;
  for (std::uint32_t lane = 0; lane < 32; ++lane) {
    if (lane % 2 == 0) {
      traces.add_lane(graph, {0, 1, 2}, {0x1000 + 4 * lane, 0x2000 + 128 * lane});
    } else {
      traces.add_lane(graph, {0, 2}, {0x1000 + 4 * lane});
    }
  }
  const Totals totals = launch_totals(graph, merged(graph, traces, 32, GetParam()));
  EXPECT_EQ(totals.global_load, (MemoryCounters{1, 4, 1, 128}));
  EXPECT_EQ(totals.global_store, (MemoryCounters{1, 16, 16, 128}));
  EXPECT_EQ(totals.shared_load, MemoryCounters{});
}

TEST_P(EveryPolicy, LanesWhosePredicateIsFalseMakeNoRequest) {
  KernelGraph graph = hand_made_graph({{}});
  add_access(graph, 0, InstructionClass::shared_store, 4);
  add_access(graph, 0, InstructionClass::shared_load, 4);
  HandMadeTraces traces;
  for (std::uint32_t lane = 0; lane < 4; ++lane)
    traces.add_lane(graph, {0}, {lane < 3 ? 32 * (lane + 1) : no_address, no_address});
  const Totals totals = launch_totals(graph, merged(graph, traces, 4, GetParam()));
  EXPECT_EQ(totals.shared_store, (MemoryCounters{1, 3, 1, 12}));
  EXPECT_EQ(totals.shared_load, MemoryCounters{});
}

TEST_P(EveryPolicy, RandomKernelsFastAndPlainAgreeAndEveryLaneSlotIsAccounted) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    RandomKernel kernel(seed);
    const std::uint32_t width = 4U << seed % 5;
    const std::uint64_t all = ~std::uint64_t{0} >> (64 - width);
    for (const std::uint64_t exist : {all, all >> 2, all & 0x5A5A5A5A5A5A5A5BU})
      for (const bool addresses : {false, true}) {
        const WarpCounters counters =
            merged(kernel.graph(), kernel.warp(width, exist, addresses), width, GetParam());
        expect_all_lane_slots_accounted(kernel.graph(), counters);
      }
  }
}

TEST(Merge, PoliciesBoundEachOther) {
  std::uint64_t ipdom = 0, loop_postdom = 0, min_pc = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    RandomKernel kernel(seed);
    const HandMadeTraces traces = kernel.warp(32, 0xFFFFFFFF, false);
    const auto issued = [&](MergePolicy policy) {
      return launch_totals(kernel.graph(), merged(kernel.graph(), traces, 32, policy)).warp_instructions;
    };
    ipdom += issued(MergePolicy::ipdom);
    loop_postdom += issued(MergePolicy::loop_postdom);
    min_pc += issued(MergePolicy::min_pc);
  }
  EXPECT_GT(ipdom, loop_postdom);
  EXPECT_GE(loop_postdom, min_pc);
}

TEST(Merge, ATraceThatDoesNotFitTheGraphIsFound) {
  const KernelGraph graph = hand_made_graph({{1, 2}, {3}, {3}, {}});
  HandMadeTraces traces;
  traces.add_lane(graph, {0, 0});
  WarpObserver nobody;
  EXPECT_THROW(make_observed_merger(graph, MergePolicy::loop_postdom, 32, nobody)->merge(traces.lanes()),
               std::logic_error);
}

}  // namespace
}  // namespace warpgrain::profiler
