#include <gtest/gtest.h>

#include "analysis/paper_bounds.hpp"

namespace warpgrain::paper {
namespace {

// The ratios and bounds as section 6 and Table 3 print them.
TEST(PaperBounds, AreThePapers) {
  EXPECT_NEAR(peak_ratio(), 44, 0.05);
  EXPECT_NEAR(simple_opencl / practical_opencl, 7.2, 0.05);
  EXPECT_NEAR(practical_opencl / practical_cpp, 6.2, 0.05);
  EXPECT_NEAR(simple_opencl / simple_cuda, 0.95, 0.005);
  EXPECT_EQ(sfu_bound(), 8);
  EXPECT_EQ(speed_up_bound(4), 8);
  EXPECT_EQ(paths_bound(5), 32);
}

// Not the 47 that the paper prints.
TEST(PaperBounds, CandidatesOfTheClosestPacking) {
  EXPECT_NEAR(candidates(), 38.184, 5e-4);
  EXPECT_NEAR(closest_packing(2.0, 0.5), 16 * 1.41421356, 1e-6);
  EXPECT_NEAR(contact_share(), 0.3143, 5e-5);
}

}  // namespace
}  // namespace warpgrain::paper
