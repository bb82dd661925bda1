// What a report's predictions take for the memory that is used in turn.

#include "reports/predicted_times.hpp"

#include <gtest/gtest.h>

#include "profiler/coalescing.hpp"
#include "tests/reports/sample.hpp"

namespace warpgrain::reports {
namespace {

// Loads a megabyte of a buffer of a gigabyte, from `first_sector` on.
profiler::LaunchProfile reads_a_piece(std::uint64_t first_sector) {
  profiler::LaunchProfile launch = sample::launch("force");
  constexpr std::uint64_t sectors = 1 << 15;
  launch.counters.buffers = {{0, std::uint64_t{1} << 30}};
  launch.counters.footprint = profiler::FootprintCounters{
      .group_load_sectors = sectors, .load_sectors = sectors, .sectors = sectors};
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

}  // namespace
}  // namespace warpgrain::reports
