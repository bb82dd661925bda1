#include <gtest/gtest.h>

#include "analysis/least_time.hpp"

namespace warpgrain {
namespace {

// 14 multiprocessors at 1.15 GHz that issue one instruction a clock and have 4 special-function units.
TEST(LeastTime, IsThatOfTheFullerUnit) {
  const Machine machine = load_machine("fermi_c2050");
  profiler::Totals totals;
  totals.warp_instructions = 14 * 1'150'000;
  totals.sfu_instructions = 14 * 1'150;
  const LeastTime issue = least_time(totals, 32, machine);
  EXPECT_DOUBLE_EQ(issue.issue, 1e-3);
  EXPECT_DOUBLE_EQ(issue.sfu, 8e-6);
  EXPECT_DOUBLE_EQ(issue.seconds(), 1e-3);
  totals.sfu_instructions = 14 * 1'150'000;
  EXPECT_DOUBLE_EQ(least_time(totals, 32, machine).seconds(), 8e-3);
}

}  // namespace
}  // namespace warpgrain
