#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/state_sample.hpp"
#include "reports/text_state_samples.hpp"
#include "sample.hpp"

namespace warpgrain::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(StateSamples, TakeTheLaunchesOfAKernelTogether) {
  profiler::LaunchCounters sort = sample::launch("sort").counters, force = sample::launch("force").counters;
  sort.totals = sample::totals(1, 0);
  const StateSample sample = state_sample(40, 0.5, {20, 31, 4, 9}, std::vector{sort, force, force});
  EXPECT_EQ(sample.step, 40u);
  EXPECT_EQ(sample.time, 0.5);
  EXPECT_EQ(sample.most_candidates, 31u);
  EXPECT_EQ(sample.most_contacts, 9u);
  ASSERT_EQ(sample.kernels.size(), 2u);
  EXPECT_EQ(sample.kernels[0].kernel, "force");
  EXPECT_EQ(sample.kernels[0].warp_instructions, 32u);  // 10 full and 6 half ones, twice
  EXPECT_DOUBLE_EQ(sample.kernels[0].simt_efficiency, 52.0 / 64);
  EXPECT_EQ(sample.kernel_named("sort")->simt_efficiency, 1);
  EXPECT_EQ(sample.kernel_named("none"), nullptr);
  EXPECT_EQ(sample.warp_instructions(), 33u);
  EXPECT_DOUBLE_EQ(sample.simt_efficiency(), (4 + 2 * 52.0) / (33 * 4));
  EXPECT_EQ(StateSample().simt_efficiency(), 0);
}

TEST(StateSamples, LeaveOutKernelsThatHardlyCount) {
  std::vector<StateSample> samples = sample::state_samples();
  EXPECT_THAT(heavy_kernels(samples), ElementsAre("force"));
  samples[0].kernels[1].warp_instructions = 100;
  EXPECT_THAT(heavy_kernels(samples), ElementsAre("force", "sort"));
  const std::string text = text_state_samples(samples);
  EXPECT_THAT(text, HasSubstr("0.900"));
  EXPECT_THAT(text, HasSubstr("-\n")) << "the second state's step has no such kernel";
  EXPECT_EQ(text_state_samples({}), "");
}

}  // namespace
}  // namespace warpgrain::reports
