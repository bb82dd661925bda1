#include <gtest/gtest.h>

#include "reports/summary.hpp"
#include "sample.hpp"

namespace warpgrain::reports {
namespace {

TEST(Summary, TakesLaunchesOfAKernelTogetherHeaviestFirst) {
  const Report report = sample::report();
  const auto kernels = kernels_of(report);
  ASSERT_EQ(kernels.size(), 2u);
  EXPECT_EQ(kernels[0].counters.kernel, "force");
  EXPECT_EQ(kernels[0].launches, 2u);
  EXPECT_EQ(kernels[0].counters.totals.warp_instructions, 32u);
  EXPECT_EQ(kernels[0].counters.totals.lane_histogram, (std::vector<std::uint64_t>{0, 0, 12, 0, 20}));
  EXPECT_EQ(kernels[0].lane_slots_lost(), 24u);
  EXPECT_EQ(kernels[0].counters.warps, 4u);
  ASSERT_EQ(kernels[0].counters.what_if.size(), 3u);
  EXPECT_EQ(kernels[0].counters.what_if[1].warps, 4u);
  EXPECT_EQ(kernels[0].counters.what_if[1].totals.warp_instructions, 26u);
  EXPECT_EQ(kernels[0].counters.blocks[0].divergent, 2u);
  EXPECT_EQ(kernels[1].counters.kernel, "sort");
  EXPECT_EQ(kernels[1].launches, 1u);
}

TEST(Summary, AddsLinesBranchesAndBlocksOfTheSamePlace) {
  Report report = sample::report();
  report.launches[2].counters.lines.push_back({"a.cl", 9, sample::totals(1, 0)});
  report.launches[2].counters.branches.push_back({.file = "a.cl",
                                                  .line = 9,
                                                  .label = "other",
                                                  .block = 1,
                                                  .executions = 1,
                                                  .divergent = 1,
                                                  .lanes = 4,
                                                  .taken_lanes = 1,
                                                  .lane_slots_lost = 100});
  const auto kernels = kernels_of(report);
  const profiler::LaunchCounters& force = kernels[0].counters;
  ASSERT_EQ(force.lines.size(), 3u);
  EXPECT_EQ(force.lines[0].file, "a.cl") << "sorted by file and line";
  EXPECT_EQ(force.lines[1].totals.warp_instructions, 20u);
  ASSERT_EQ(force.branches.size(), 2u);
  EXPECT_EQ(force.branches[0].label, "other") << "largest loss first";
  EXPECT_EQ(force.branches[1].lane_slots_lost, 24u);
  EXPECT_EQ(force.branches[1].taken_lanes, 8u);
  EXPECT_EQ(force.blocks[1].lane_histogram[2], 4u);
}

TEST(Summary, KeepsKernelsOfOtherSourcesApart) {
  Report report = sample::report();
  report.launches[2].source.hash = text_hash("another");
  EXPECT_EQ(kernels_of(report).size(), 3u);
}

TEST(Summary, HeadlineIsOverLaneSlotsNotAMeanOfRatios) {
  Report report = sample::report();
  report.launches.resize(2);
  report.launches[1].counters.totals = sample::totals(0, 84);  // with 16 of the other: 100 warp instructions
  const Headline headline = headline_of(kernels_of(report));
  EXPECT_EQ(headline.warp_instructions, 100u);
  EXPECT_EQ(headline.thread_instructions, 220u);
  EXPECT_DOUBLE_EQ(headline.active_lanes, 2.2);
  EXPECT_DOUBLE_EQ(headline.simt_efficiency, 0.55);
  EXPECT_DOUBLE_EQ(headline.sectors_per_load.value(), 3.0);
  EXPECT_EQ(headline.heaviest_kernel.kernel, "force");
  EXPECT_DOUBLE_EQ(headline.heaviest_kernel.share, 0.84);
  EXPECT_DOUBLE_EQ(headline.heaviest_kernel.simt_efficiency, 0.5);
}

TEST(Summary, NoLoadsHaveNoSectorsPerLoad) {
  profiler::LaunchCounters counters;
  counters.totals = sample::totals(0, 3);
  EXPECT_FALSE(headline_of(counters).sectors_per_load.has_value());
  EXPECT_DOUBLE_EQ(headline_of(profiler::LaunchCounters{}).simt_efficiency, 0.0);
}

}  // namespace
}  // namespace warpgrain::reports
