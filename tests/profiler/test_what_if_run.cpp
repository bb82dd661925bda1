// Every answer against a run of its own: with that width and policy, or over traces that stand in that order.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <optional>
#include <sstream>

#include "core/error.hpp"
#include "profiler/launch_file.hpp"
#include "profiler/profile.hpp"
#include "profiler/thread_permutation.hpp"
#include "tests/paths.hpp"
#include "tests/profiler/traced_executable.hpp"

namespace warpgrain::profiler {
namespace {

using testing::HasSubstr;

constexpr std::uint32_t widths[] = {4, 8, 16, 32, 64};
constexpr MergePolicy policies[] = {MergePolicy::loop_postdom, MergePolicy::ipdom, MergePolicy::min_pc};

// A random kernel with random lanes; in some launches lanes are missing.
struct RandomLaunch {
  RandomLaunch(std::uint64_t seed, std::size_t n_groups, std::uint32_t group_size, bool addresses = false)
      : kernel(seed) {
    const std::uint64_t all = ~std::uint64_t{0} >> (64 - group_size);
    for (std::size_t g = 0; g < n_groups; ++g)
      traces.push_back(kernel.warp(group_size, seed % 3 == 0 ? all & ~(seed << 3) : all, addresses));
  }
  TracedExecutable executable() {
    std::vector<std::vector<LaneTrace>> groups;
    for (const HandMadeTraces& group : traces) groups.push_back(group.lanes());
    return TracedExecutable(kernel.graph(), groups);
  }
  RandomKernel kernel;
  std::vector<HandMadeTraces> traces;  // of the groups
};

LaunchCounters counted(const TracedExecutable& executable, const ProfileOptions& options) {
  return profile_launch(executable, executable.shape(), {}, "", options);
}

std::vector<WhatIf> every_width_and_policy(const ThreadOrder& order = {}) {
  std::vector<WhatIf> questions;
  for (const std::uint32_t width : widths)
    for (const MergePolicy policy : policies) questions.push_back({width, policy, order, 0});
  return questions;
}

void expect_equal_runs(const LaunchCounters& asked, const TracedExecutable& executable, bool addresses) {
  std::size_t k = 0;
  for (const std::uint32_t width : widths)
    for (const MergePolicy policy : policies) {
      const LaunchCounters run =
          counted(executable, {.policy = policy, .warp_width = width, .addresses = addresses, .threads = 1});
      const WhatIfTotals& answer = asked.what_if.at(k++);
      EXPECT_EQ(answer.warp_width, width);
      EXPECT_EQ(answer.policy, merge_policy_name(policy));
      EXPECT_EQ(answer.warps, run.warps);
      EXPECT_EQ(answer.totals, run.totals) << width << " lanes, " << answer.policy << ", " << answer.order;
    }
}

TEST(WhatIf, WidthsAndPoliciesAreThoseOfRunsOfTheirOwn) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const bool addresses = seed % 2 == 0;
    RandomLaunch launch(seed, 40, 48, addresses);
    const TracedExecutable executable = launch.executable();
    const LaunchCounters asked =
        counted(executable, {.addresses = addresses, .threads = 3, .what_if = every_width_and_policy()});
    expect_equal_runs(asked, executable, addresses);
    EXPECT_EQ(asked.what_if[0].has_requests, addresses);
    EXPECT_EQ(asked.totals, counted(executable, {.addresses = addresses}).totals) << "asking changes nothing";
  }
}

// The launch with its threads in the places that `order` gives them.
TracedExecutable reordered(const TracedExecutable& executable, const ThreadOrder& order) {
  std::vector<LaneTrace> threads;
  for (const auto& group : executable.groups()) threads.insert(threads.end(), group.begin(), group.end());
  TraceStore store(threads.size(), 1 << 30);
  TraceStore::Writer(store).keep(0, threads);
  const auto key = ThreadKey::find(executable.graph(), SourceLines("", ""), order.key);
  const std::size_t group_size = executable.groups()[0].size();
  const auto places = permuted_threads(order, key ? &*key : nullptr, store,
                                       executable.graph().has_barrier ? group_size : threads.size());
  std::vector<std::vector<LaneTrace>> groups;
  for (std::size_t place = 0; place < places.size(); ++place) {
    if (place % group_size == 0) groups.emplace_back();
    groups.back().push_back({threads[places[place]].blocks, nullptr});
  }
  return TracedExecutable(executable.graph(), groups);
}

TEST(WhatIf, OrdersAreThoseOfRunsOverPermutedTraces) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    RandomLaunch launch(seed, 20, 40);
    launch.kernel.graph().has_barrier = seed % 2 == 1;
    const TracedExecutable executable = launch.executable();
    for (const char* name : {"shuffled:5", "sorted", "sorted:hand.cl:1"}) {
      const ThreadOrder order = ThreadOrder::from_name(name, "");
      const LaunchCounters asked =
          counted(executable, {.addresses = false, .threads = 2, .what_if = every_width_and_policy(order)});
      expect_equal_runs(asked, reordered(executable, order), false);
      EXPECT_EQ(asked.what_if[0].order, order.name());
      EXPECT_FALSE(asked.what_if[0].has_requests);
      EXPECT_EQ(asked.what_if[0].remark.empty(), !executable.graph().has_barrier);
    }
  }
}

TEST(WhatIf, SortingByInstructionsPutsEqualThreadsTogether) {
  // Of 64 threads every other one goes three times through the loop; sorted, warps of four never part.
  const KernelGraph graph = hand_made_graph({{1}, {1, 2}, {}}, {2, 10, 3});
  HandMadeTraces traces;
  for (std::uint32_t lane = 0; lane < 64; ++lane)
    lane % 2 == 0 ? traces.add_lane(graph, {0, 1, 2}) : traces.add_lane(graph, {0, 1, 1, 1, 2});
  const TracedExecutable executable(graph, {traces.lanes()});
  const LaunchCounters asked = counted(
      executable, {.warp_width = 4,
                   .threads = 1,
                   .what_if = {{4, MergePolicy::loop_postdom, {}, 0},
                               {4, MergePolicy::loop_postdom, ThreadOrder::from_name("sorted", ""), 0}}});
  EXPECT_EQ(asked.what_if[0].totals.warp_instructions, 16U * (2 + 30 + 3));
  EXPECT_EQ(asked.what_if[1].totals.warp_instructions, 8U * (2 + 30 + 3) + 8U * (2 + 10 + 3));
  EXPECT_EQ(asked.what_if[1].totals.divergent_branches, 0U);
  EXPECT_EQ(asked.what_if[1].totals.simt_efficiency(4), 1.0);
}

TEST(WhatIf, BoundsAreNeverAboveAPolicyAndDoNotDependOnThreads) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    RandomLaunch launch(seed, 37, 48);
    const TracedExecutable executable = launch.executable();
    std::vector<WhatIf> questions;
    for (const std::uint32_t pool : {16U, 64U, 1024U})
      questions.push_back({16, MergePolicy::min_pc, {}, pool});
    questions.push_back({16, MergePolicy::min_pc, {}, 0});
    const LaunchCounters one = counted(executable, {.threads = 1, .what_if = questions});
    const LaunchCounters four = counted(executable, {.threads = 4, .what_if = questions});
    EXPECT_EQ(one.what_if, four.what_if);
    const std::uint64_t reached = one.what_if[3].totals.warp_instructions;
    EXPECT_LE(one.what_if[0].totals.warp_instructions, reached);
    EXPECT_LE(one.what_if[1].totals.warp_instructions, one.what_if[0].totals.warp_instructions);
    EXPECT_LE(one.what_if[2].totals.warp_instructions, one.what_if[1].totals.warp_instructions);
    for (const WhatIfTotals& answer : one.what_if)
      EXPECT_EQ(answer.totals.thread_instructions, one.totals.thread_instructions);
  }
}

TEST(WhatIf, PoolsOfAKernelWithBarriersAreOfOneWorkGroup) {
  // Two groups of six threads: one way in the first, the other in the second. Pools of 16 over both would
  // issue each block once.
  KernelGraph graph = hand_made_graph({{1, 2}, {3}, {3}, {}});
  HandMadeTraces first, second;
  for (int lane = 0; lane < 6; ++lane) {
    first.add_lane(graph, {0, 1, 3});
    second.add_lane(graph, {0, 2, 3});
  }
  const std::vector<WhatIf> question{{16, MergePolicy::loop_postdom, {}, 16}};
  const TracedExecutable free(graph, {first.lanes(), second.lanes()});
  EXPECT_EQ(counted(free, {.what_if = question}).what_if[0].totals.warp_instructions, 4U);
  graph.has_barrier = true;
  const TracedExecutable bound(graph, {first.lanes(), second.lanes()});
  const WhatIfTotals answer = counted(bound, {.what_if = question}).what_if[0];
  EXPECT_EQ(answer.totals.warp_instructions, 6U);
  EXPECT_THAT(answer.remark, HasSubstr("barriers"));
}

std::string refusal(const WhatIf& question, std::uint64_t trace_memory = 1 << 20) {
  RandomLaunch launch(1, 4, 32);
  try {
    counted(launch.executable(), {.what_if = {question}, .trace_memory = trace_memory});
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(WhatIf, RefusesWhatCannotBeAnswered) {
  EXPECT_THAT(refusal({24, MergePolicy::min_pc, {}, 0}),
              HasSubstr("24; expected a power of two from 4 to 64"));
  EXPECT_THAT(refusal({32, MergePolicy::min_pc, {}, 16}), HasSubstr("16 threads; expected a power of two"));
  EXPECT_THAT(refusal({32, MergePolicy::min_pc, {}, 2048}), HasSubstr("from the warp width, 32, to 1024"));
  const WhatIf sorted{32, MergePolicy::min_pc, ThreadOrder::from_name("sorted:trips", ""), 0};
  EXPECT_THAT(refusal(sorted), HasSubstr("unknown thread count 'trips'; valid: thread_instructions, "));
  EXPECT_THAT(refusal({32, MergePolicy::min_pc, ThreadOrder::from_name("shuffled", ""), 0}, 2000),
              HasSubstr("the traces of the launch's threads take more than 0 MiB"));
}

TEST(WhatIf, QuestionsByUnknownCountsCanBeLeftOut) {
  RandomLaunch launch(1, 4, 32);
  const LaunchCounters asked =
      counted(launch.executable(),
              {.what_if = {{32, MergePolicy::min_pc, ThreadOrder::from_name("sorted:trips", ""), 0},
                           {8, MergePolicy::min_pc, {}, 0}},
               .skip_unknown_keys = true});
  ASSERT_EQ(asked.what_if.size(), 1U);
  EXPECT_EQ(asked.what_if[0].warp_width, 8U);
}

class LaunchFiles : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(WhatIf, LaunchFiles,
                         testing::Values("bitonic_sort", "break_and_continue", "early_return",
                                         "half_and_half", "sectors", "switch", "trip_count"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST_P(LaunchFiles, AreAnsweredAsByRunsOfTheirOwn) {
  const LaunchFile file = read_launch_file(std::filesystem::path(source_path("tests/profiler/data")) /
                                           (std::string(GetParam()) + ".sim"));
  std::ostringstream dump;
  const auto counters = [&](const ProfileOptions& options) {
    return profile_launch_file(file, "", options, dump).profile.counters;
  };
  const LaunchCounters asked = counters({.what_if = {{8, MergePolicy::min_pc, {}, 0},
                                                     {64, MergePolicy::ipdom, {}, 0},
                                                     {16, MergePolicy::loop_postdom, {}, 0}}});
  EXPECT_EQ(asked.what_if[0].totals, counters({.policy = MergePolicy::min_pc, .warp_width = 8}).totals);
  EXPECT_EQ(asked.what_if[1].totals, counters({.policy = MergePolicy::ipdom, .warp_width = 64}).totals);
  EXPECT_EQ(asked.what_if[2].totals, counters({.warp_width = 16}).totals);
}

}  // namespace
}  // namespace warpgrain::profiler
