// What a report's predictions take for the memory that is used in turn.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "profiler/coalescing.hpp"
#include "reports/predicted_times.hpp"
#include "reports/summary.hpp"
#include "tests/reports/sample.hpp"

namespace warpgrain::reports {
namespace {

// Loads a megabyte of a buffer of a gigabyte, from `first_sector` on.
profiler::LaunchProfile reads_a_piece(std::uint64_t first_sector) {
  profiler::LaunchProfile launch = sample::launch("force");
  constexpr std::uint64_t sectors = 1 << 15;
  launch.counters.buffers = {{0, std::uint64_t{1} << 30}};
  launch.counters.footprint =
      profiler::FootprintCounters{.group_load_sectors = sectors, .load_sectors = sectors, .sectors = sectors};
  launch.counters.touched.clear();
  for (std::uint64_t k = 0; k < sectors; ++k)
    add_sector(launch.counters.touched, (first_sector + k) * profiler::sector_bytes);
  return launch;
}

Report report_of(std::vector<profiler::LaunchProfile> launches) {
  Report report = make_report(launches, "warpgrain profile");
  report.machine = load_machine("hopper_h100");
  return report;
}

TEST(PredictedTimes, WhatLaunchesTouchTogetherCountsOnce) {
  EXPECT_EQ(report_of({reads_a_piece(0), reads_a_piece(1 << 14)}).touched_bytes, 3u << 19);
  std::vector launches{reads_a_piece(0), reads_a_piece(0)};
  launches[1].counters.footprint.reset();
  EXPECT_EQ(report_of(launches).touched_bytes, std::nullopt) << "nobody knows";
}

TEST(PredictedTimes, AStepMeetsAgainWhatItTouchesAndALaunchAloneAllOfItsBuffers) {
  Report report = report_of({reads_a_piece(0), reads_a_piece(0)});
  report.scene = std::nullopt;
  const double alone = predicted_time(report, report.launches[0])->memory;
  report.scene = "slit";
  const double of_step = predicted_time(report, report.launches[0])->memory;
  EXPECT_LT(of_step, 0.5 * alone) << "a megabyte stays in the second cache, a gigabyte does not";
  report.touched_bytes.reset();
  EXPECT_DOUBLE_EQ(predicted_time(report, report.launches[0])->memory, alone);
}

TEST(PredictedTimes, AStepHasItsShareOfMakingLists) {
  Report report = report_of({reads_a_piece(0)});
  report.scene = "slit";
  const double kept = *headline_of(report).predicted_seconds;
  report.list_making = ListMaking{20, 1, 1, 1e-3};
  EXPECT_DOUBLE_EQ(*headline_of(report).predicted_seconds, kept + 5e-5);
  report.list_making->predicted_seconds.reset();
  EXPECT_DOUBLE_EQ(*headline_of(report).predicted_seconds, kept);
}

TEST(PredictedTimes, MakingListsFindsInTheCacheWhatTheStepLeaves) {
  const std::vector step{reads_a_piece(0)}, lists{reads_a_piece(0), reads_a_piece(1 << 15)};
  const ListMaking making = list_making(step, lists, 7, load_machine("hopper_h100"));
  EXPECT_EQ(making.steps_between, 7u);
  EXPECT_EQ(making.warp_instructions, 2 * step[0].counters.totals.warp_instructions);
  EXPECT_EQ(making.thread_instructions, 2 * step[0].counters.totals.thread_instructions);
  Report of_both = report_of({lists[0], lists[1]});
  of_both.scene = "slit";
  EXPECT_DOUBLE_EQ(*making.predicted_seconds, *headline_of(of_both).predicted_seconds);
  EXPECT_EQ(list_making(step, lists, 7, std::nullopt).predicted_seconds, std::nullopt);
  EXPECT_THAT(text_of(making), testing::HasSubstr("about every 7 steps"));
}

}  // namespace
}  // namespace warpgrain::reports
