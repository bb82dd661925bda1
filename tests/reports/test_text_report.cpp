#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/text_report.hpp"
#include "sample.hpp"

namespace warpgrain::reports {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(TextReport, SaysWhatWasProfiledAndItsTotals) {
  const std::string text = text_report(sample::report());
  EXPECT_THAT(text, HasSubstr("slit, branchy/cells/cell/fp32/default, 16,384 particles, step 4,000\n"));
  EXPECT_THAT(
      text,
      HasSubstr(
          "force          2       0.812     3.2            32     50.0 %            12          3.00\n"));
  EXPECT_THAT(text, HasSubstr("all            3"));
}

TEST(TextReport, SharesTheLossAmongBranches) {
  const std::string text = text_report(sample::report());
  EXPECT_THAT(
      text,
      HasSubstr("force: where lanes idled, of 24 lost lane slots\n"
                "  100.0 %  contact test  (contact/law.cl:2)  lanes disagreed in 50.0 % of 4 executions\n"));
}

TEST(TextReport, QuotesTheHottestLines) {
  const std::string text = text_report(sample::report());
  EXPECT_THAT(
      text,
      HasSubstr("   62.5 %   4.0 lanes  contact/law.cl:2  if (i < 2 && i > -1)  // branch: contact test\n"
                "   37.5 %   2.0 lanes  contact/law.cl:3  force[i] = sqrt(overlap) /* <&> */;\n"));
}

TEST(TextReport, CountsWarpsThatAreNotFull) {
  Report report = sample::report();
  report.launches[0].counters.branches.clear();
  report.launches[0].counters.lane_slots_never_used = 12;
  EXPECT_THAT(text_report(report), HasSubstr("sort: where lanes idled, of 12 lost lane slots\n"
                                             "  100.0 %  warps that are not full from the start\n"));
}

TEST(TextReport, SortsCausesByLossAndNamesWhatHasNoLine) {
  Report report = sample::report();
  report.launches.resize(1);
  profiler::LaunchCounters& counters = report.launches[0].counters;
  counters.branches[0].lane_slots_lost = 3;
  counters.branches[0].file = "/home/user/law.cl";
  counters.lane_slots_never_used = 9;
  counters.lines.push_back({"", 0, sample::totals(100, 0)});
  const std::string text = text_report(report);
  EXPECT_THAT(text, HasSubstr("   75.0 %  warps that are not full from the start\n"
                              "   25.0 %  contact test  (law.cl:2)  lanes"));
  EXPECT_THAT(text, HasSubstr("4.0 lanes  instructions without a line\n"));
}

TEST(TextReport, TabulatesTheAnswers) {
  const std::string text = text_report(sample::report());
  EXPECT_THAT(text, HasSubstr("force: what if (the run: 4 lanes, loop_postdom, as launched)\n"));
  EXPECT_THAT(text, HasSubstr("    4  min_pc              launched                  0.929            28   "
                              "87.5 %        0 %          3.00\n"));
  EXPECT_THAT(text, HasSubstr("    4  bound, pools of 64  launched                  1.000            22   "
                              "68.8 %          -             -\n  the <kernel> has barriers\n"));
}

TEST(TextReport, SaysWhatSpecialFunctionsCost) {
  EXPECT_THAT(
      text_report(sample::report()),
      HasSubstr("fermi_c2050: an instruction on the special-function units takes 8.0 times the cycles of "
                "32-bit arithmetic\n"));
  Report report = sample::report();
  report.machine.reset();
  EXPECT_THAT(text_report(report), Not(HasSubstr("special-function units")));
}

TEST(TextReport, LimitsItsDetails) {
  const std::string text = text_report(sample::report(), {.kernels = 1, .causes = 1, .lines = 1});
  EXPECT_THAT(text, Not(HasSubstr("sort: ")));
  EXPECT_THAT(text, Not(HasSubstr("contact/law.cl:3")));
}

TEST(TextReport, WithoutASceneTheKernelsAreTheTitle) {
  Report report = sample::report();
  report.scene.reset();
  report.variant.reset();
  report.particles.reset();
  report.step.reset();
  EXPECT_THAT(text_report(report), testing::StartsWith("sort, force\n"));
}

}  // namespace
}  // namespace warpgrain::reports
