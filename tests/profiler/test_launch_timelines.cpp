#include <algorithm>
#include <bit>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>

#include "profiler/profile.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

using testing::ElementsAre;

// Lane i goes round trips[i] times.
constexpr const char* rounds_kernel = R"(
kernel void k(global const int* trips, global volatile int* out) {
  const int i = get_global_id(0);
  for (int trip = 0; trip < trips[i]; ++trip) out[i] = trip;
})";

class LaunchTimelinesTest : public testing::Test {
 protected:
  LaunchCounters profiled(std::vector<int> trips, const TimelineOptions& options, unsigned threads = 1,
                          std::uint32_t local_size = 32) const {
    std::vector<int> out(trips.size());
    ProfileOptions how;
    how.timelines = options;
    how.threads = threads;
    how.addresses = false;
    return profile_launch(*executable_, line_of(trips.size(), local_size),
                          {{buffer_of(trips), buffer_of(out)}}, rounds_kernel, how);
  }
  // Warps of 32 of which the first lane goes round many times and the others once.
  static std::vector<int> lopsided(const std::vector<int>& of_warps) {
    std::vector<int> trips(32 * of_warps.size(), 1);
    for (std::size_t warp = 0; warp < of_warps.size(); ++warp) trips[32 * warp] = of_warps[warp];
    return trips;
  }
  static const WarpTimeline* chosen_as(const LaunchCounters& counters, const std::string& reason) {
    for (const WarpTimeline& timeline : counters.timelines)
      if (std::ranges::find(timeline.chosen_as, reason) != timeline.chosen_as.end()) return &timeline;
    return nullptr;
  }

  std::unique_ptr<Executable> executable_ = compile_kernel(rounds_kernel, "k", TraceMode::blocks);
};

TEST_F(LaunchTimelinesTest, HoldWhatTheCountersSum) {
  TimelineOptions options;
  options.warps = {0};
  const LaunchCounters counters = profiled(lopsided({9}), options);
  ASSERT_EQ(counters.timelines.size(), 1U);
  const WarpTimeline& timeline = counters.timelines[0];
  EXPECT_THAT(timeline.chosen_as, ElementsAre("number"));
  EXPECT_EQ(timeline.executions, timeline.blocks.size());
  EXPECT_EQ(timeline.sums.warp_instructions, counters.totals.warp_instructions);
  EXPECT_EQ(timeline.sums.thread_instructions, counters.totals.thread_instructions);
  EXPECT_EQ(timeline.sums, counters.warp_sums.at(0));
  for (const BlockTotals& block : counters.blocks) {
    std::vector<std::uint64_t> histogram(33);
    for (std::size_t k = 0; k < timeline.blocks.size(); ++k)
      if (timeline.blocks[k] == block.block)
        ++histogram[static_cast<std::size_t>(std::popcount(timeline.lanes[k]))];
    EXPECT_EQ(histogram, block.lane_histogram) << block.label;
  }
  EXPECT_EQ(timeline.lanes.front(), 0xFFFFFFFFU);
  EXPECT_EQ(std::ranges::count(timeline.lanes, 1U), 8);  // the first lane's rounds alone
}

TEST_F(LaunchTimelinesTest, NameTheLineThatABlockBeginsWith) {
  const LaunchCounters counters = profiled(lopsided({2}), {});
  EXPECT_TRUE(std::ranges::any_of(counters.blocks, [](const BlockTotals& block) { return block.line == 4; }));
  EXPECT_TRUE(counters.timelines.empty());
}

TEST_F(LaunchTimelinesTest, FindTheWarpsThatStandOut) {
  TimelineOptions options;
  options.median = options.worst = options.costliest = true;
  // The longest loop of one lane is both the worst and the costliest of these.
  std::vector<int> of_warps(70);
  for (std::size_t warp = 0; warp < of_warps.size(); ++warp)
    of_warps[warp] = 2 + static_cast<int>(warp * 37 % 70);
  std::vector<int> trips = lopsided(of_warps);
  // Of two kinds: warp 5 idles more slots, since half of it waits for the other half for long.
  for (std::size_t lane = 0; lane < 16; ++lane) trips[32 * 5 + lane] = 400;
  const LaunchCounters counters = profiled(trips, options);
  const auto worst = static_cast<std::uint64_t>(std::ranges::max_element(of_warps) - of_warps.begin());
  ASSERT_NE(chosen_as(counters, "worst"), nullptr);
  EXPECT_EQ(chosen_as(counters, "worst")->warp, worst);
  ASSERT_NE(chosen_as(counters, "costliest"), nullptr);
  EXPECT_EQ(chosen_as(counters, "costliest")->warp, 5U);
  std::vector<double> efficiencies;
  for (const WarpSums& sums : counters.warp_sums)
    efficiencies.push_back(static_cast<double>(sums.thread_instructions) /
                           static_cast<double>(sums.warp_instructions));
  std::ranges::sort(efficiencies);
  const WarpTimeline* median = chosen_as(counters, "median");
  ASSERT_NE(median, nullptr);
  const double of_median = static_cast<double>(median->sums.thread_instructions) /
                           static_cast<double>(median->sums.warp_instructions);
  EXPECT_GE(of_median, efficiencies[25]);
  EXPECT_LE(of_median, efficiencies[45]);
  for (const unsigned threads : {2U, 5U})
    EXPECT_EQ(profiled(trips, options, threads).timelines, counters.timelines);
}

TEST_F(LaunchTimelinesTest, AreCutAndSayHowLongTheyWere) {
  TimelineOptions whole, cut;
  whole.warps = cut.warps = {1, 99};
  cut.max_executions = 5;
  const WarpTimeline all = profiled(lopsided({3, 20}), whole).timelines.at(0);
  const LaunchCounters counters = profiled(lopsided({3, 20}), cut);
  ASSERT_EQ(counters.timelines.size(), 1U);  // there is no warp 99
  const WarpTimeline& timeline = counters.timelines[0];
  EXPECT_EQ(timeline.warp, 1U);
  EXPECT_EQ(timeline.executions, all.executions);
  EXPECT_GT(timeline.executions, 20U);
  EXPECT_EQ(timeline.sums, all.sums);
  EXPECT_TRUE(std::ranges::equal(timeline.blocks, std::vector(all.blocks.begin(), all.blocks.begin() + 5)));
}

TEST_F(LaunchTimelinesTest, NumberTheWarpsOfEachWorkGroup) {
  TimelineOptions options;
  options.warps = {3};
  std::vector<int> trips(96, 1);  // two work-groups of a full warp and half of one
  trips[48 + 32] = 7;             // the first lane of the second's half
  const LaunchCounters counters = profiled(trips, options, 1, 48);
  ASSERT_EQ(counters.warp_sums.size(), 4U);
  ASSERT_EQ(counters.timelines.size(), 1U);
  EXPECT_EQ(counters.timelines[0].lanes.front(), 0xFFFFU);
  EXPECT_GT(counters.timelines[0].executions, 7U);
}

}  // namespace
}  // namespace warpgrain::profiler
