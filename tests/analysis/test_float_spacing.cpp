#include <gtest/gtest.h>

#include "analysis/float_spacing.hpp"

namespace warpgrain {
namespace {

TEST(FloatSpacing, IsThatOfFloats) {
  EXPECT_EQ(in_float_ulps(0x1p-23, 1.0), 1);
  EXPECT_EQ(in_float_ulps(0x1p-23, 1.999), 1);
  EXPECT_EQ(in_float_ulps(0x1p-23, 2.0), 0.5);
  EXPECT_EQ(in_float_ulps(1, 0), 0);
}

}  // namespace
}  // namespace warpgrain
