#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "analysis/prediction_error.hpp"
#include "core/error.hpp"

namespace warpgrain {
namespace {

using Values = std::vector<double>;

TEST(PredictionError, IsRelativeToWhatWasMeasured) {
  const PredictionError error = prediction_error(Values{1.1, 1.0, 8.0}, Values{1.0, 2.0, 8.0});
  EXPECT_NEAR(error.median, 0.1, 1e-12);
  EXPECT_NEAR(error.largest, 0.5, 1e-12);
}

TEST(PredictionError, RefusesWhatHasNone) {
  EXPECT_THROW(prediction_error(Values{1}, Values{1, 2}), InputError);
  EXPECT_THROW(prediction_error(Values{}, Values{}), InputError);
  EXPECT_THROW(prediction_error(Values{1}, Values{0}), InputError);
  EXPECT_THROW(prediction_error(Values{1}, Values{std::nan("")}), InputError);
}

TEST(LeaveOneOut, ShowsWhatHangsOnOneThing) {
  // Without the last all are in order; with it half of the pairs are not.
  const auto range = leave_one_out(Values{1, 2, 3, 0.5}, Values{1, 2, 3, 4});
  EXPECT_DOUBLE_EQ(range->tau.upper, 1);
  EXPECT_DOUBLE_EQ(range->tau.lower, -1.0 / 3);
  EXPECT_DOUBLE_EQ(range->median_error.lower, 0);
  EXPECT_FALSE(leave_one_out(Values{1, 2}, Values{1, 2}));
  EXPECT_FALSE(leave_one_out(Values{1, 1, 2}, Values{1, 2, 3})) << "two equal predictions order no pair";
}

}  // namespace
}  // namespace warpgrain
