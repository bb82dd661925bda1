#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "analysis/statistics.hpp"
#include "core/error.hpp"

namespace warpgrain {
namespace {

TEST(Statistics, MedianOfOddAndEvenCounts) {
  EXPECT_DOUBLE_EQ(median(std::vector{3.0, 1.0, 2.0}), 2.0);
  EXPECT_DOUBLE_EQ(median(std::vector{4.0, 1.0, 2.0, 3.0}), 2.5);
  EXPECT_DOUBLE_EQ(median(std::vector{7.0}), 7.0);
}

TEST(Statistics, PercentilesAreInterpolatedAsNumPyDoes) {
  // numpy.percentile([1, 2, 4, 8], [0, 10, 25, 75, 100])
  const std::vector readings{8.0, 1.0, 4.0, 2.0};
  EXPECT_DOUBLE_EQ(percentile(readings, 0), 1.0);
  EXPECT_DOUBLE_EQ(percentile(readings, 10), 1.3);
  EXPECT_DOUBLE_EQ(percentile(readings, 25), 1.75);
  EXPECT_DOUBLE_EQ(percentile(readings, 75), 5.0);
  EXPECT_DOUBLE_EQ(percentile(readings, 100), 8.0);
}

TEST(Statistics, SpreadIsOverTheMedian) {
  const Spread spread = spread_of(std::vector{1.0, 2.0, 3.0, 4.0, 100.0});
  EXPECT_EQ(spread.readings, 5u);
  EXPECT_DOUBLE_EQ(spread.minimum, 1.0);
  EXPECT_DOUBLE_EQ(spread.median, 3.0);
  EXPECT_DOUBLE_EQ(spread.maximum, 100.0);
  EXPECT_DOUBLE_EQ(spread.relative_spread(), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(spread_of(std::vector{0.0, 0.0}).relative_spread(), 0.0);
}

TEST(Statistics, RefusesNothingNanAndBadPercentages) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(median({}), InputError);
  EXPECT_THROW(median(std::vector{1.0, nan}), InputError);
  EXPECT_THROW(percentile(std::vector{1.0}, 100.5), InputError);
  EXPECT_THROW(percentile(std::vector{1.0}, nan), InputError);
}

}  // namespace
}  // namespace warpgrain
