#include <cmath>
#include <gtest/gtest.h>

#include "analysis/rank_correlation.hpp"
#include "core/error.hpp"

namespace warpgrain {
namespace {

using Values = std::vector<double>;

TEST(RankCorrelation, OfOrdersAndTheirReverse) {
  EXPECT_DOUBLE_EQ(*kendall_tau(Values{1, 2, 3, 4}, Values{10, 20, 30, 400}), 1);
  EXPECT_DOUBLE_EQ(*kendall_tau(Values{1, 2, 3, 4}, Values{4, 3, 2, 1}), -1);
  // One of six pairs the other way round.
  EXPECT_DOUBLE_EQ(*kendall_tau(Values{1, 2, 3, 4}, Values{1, 3, 2, 4}), 4.0 / 6);
}

TEST(RankCorrelation, TiesCountForNeither) {
  // Five pairs ordered by the first, six by the second; all five alike.
  EXPECT_DOUBLE_EQ(*kendall_tau(Values{1, 1, 3, 4}, Values{1, 2, 3, 4}), 5 / std::sqrt(30.0));
  EXPECT_FALSE(kendall_tau(Values{2, 2}, Values{1, 3}));
  EXPECT_FALSE(kendall_tau(Values{}, Values{}));
}

TEST(RankCorrelation, IntervalsSpanWhatReadingsAllow) {
  const auto sure = kendall_interval(Values{1, 2, 3}, std::vector<Values>{{1, 1.1}, {2, 2.1}, {3, 3.1}});
  EXPECT_DOUBLE_EQ(sure->lower, 1);
  EXPECT_DOUBLE_EQ(sure->upper, 1);
  const auto unsure = kendall_interval(Values{1, 2}, std::vector<Values>{{1, 3}, {2, 2.1}});
  EXPECT_DOUBLE_EQ(unsure->lower, -1);
  EXPECT_DOUBLE_EQ(unsure->upper, 1);
}

TEST(RankCorrelation, RefusesWhatHasNoOrder) {
  EXPECT_THROW(kendall_tau(Values{1}, Values{1, 2}), InputError);
  EXPECT_THROW(kendall_tau(Values{1, std::nan("")}, Values{1, 2}), InputError);
  EXPECT_THROW(kendall_interval(Values{1, 2}, std::vector<Values>{{1}, {}}), InputError);
}

}  // namespace
}  // namespace warpgrain
