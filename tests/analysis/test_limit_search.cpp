#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "analysis/limit_search.hpp"
#include "core/error.hpp"

namespace warpgrain {
namespace {

// Errors that grow as a power of x past some place: both limits must enclose where the bounds are reached,
// within the width that so many halvings leave, whichever way the range runs.
TEST(LimitSearch, EnclosesTheBoundOfAMonotonicError) {
  constexpr unsigned seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-9, 9), power(0.5, 3);
  for (int k = 0; k < 300; ++k) {
    const double place = std::pow(10, exponent(random)), p = power(random);
    const double sign = k % 2 ? 1 : -1;
    const SearchRange range{std::pow(10, -10 * sign), std::pow(10, 10 * sign), 5, 8};
    const auto error = [&](double x) { return 0.01 * std::pow(x / place, sign * p); };
    const std::array bounds{0.01, 0.05};
    const auto limits = find_limits(error, range, bounds);
    ASSERT_EQ(limits.size(), 2U);
    for (std::size_t b = 0; b < bounds.size(); ++b) {
      const double reached = place * std::pow(bounds[b] / 0.01, sign / p);
      ASSERT_TRUE(limits[b].until) << place;
      if (!limits[b].beyond) {
        EXPECT_GT(sign * std::log(reached / range.to), 0);
        continue;
      }
      EXPECT_LE(sign * std::log(*limits[b].until), sign * std::log(reached) + 1e-9);
      EXPECT_GE(sign * std::log(*limits[b].beyond), sign * std::log(reached) - 1e-9);
      EXPECT_NEAR(std::abs(std::log10(*limits[b].beyond / *limits[b].until)), 20.0 / 4 / 256, 1e-6);
    }
  }
}

TEST(LimitSearch, KnowsRangesThatAreAllRightOrAllWrong) {
  const std::array bounds{0.01};
  const auto right = find_limits([](double) { return 0.0; }, {1, 100}, bounds);
  EXPECT_EQ(right[0].until, 100);
  EXPECT_FALSE(right[0].beyond);
  const auto wrong = find_limits([](double) { return 1.0; }, {1, 100}, bounds);
  EXPECT_FALSE(wrong[0].until);
  EXPECT_EQ(wrong[0].beyond, 1);
}

TEST(LimitSearch, TakesWhatIsNoNumberForWrong) {
  const std::array bounds{0.01, 0.05};
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const auto limits = find_limits([&](double x) { return x > 10 ? bad : 0; }, {1, 100, 5, 30}, bounds);
    EXPECT_NEAR(*limits[0].until, 10, 1e-6);
    EXPECT_NEAR(*limits[1].beyond, 10, 1e-6);
  }
}

TEST(LimitSearch, AsksForEachValueOnce) {
  std::vector<double> asked;
  const std::array bounds{0.01, 0.05};
  find_limits(
      [&](double x) {
        asked.push_back(x);
        return x;
      },
      {1e-4, 1, 5, 4}, bounds);
  ASSERT_GE(asked.size(), 2U);
  EXPECT_EQ(asked[0], 1e-4);
  EXPECT_EQ(asked[1], 1);
  std::sort(asked.begin(), asked.end());
  EXPECT_EQ(std::adjacent_find(asked.begin(), asked.end()), asked.end());
}

TEST(LimitSearch, RefusesRangesThatAreNone) {
  const auto search = [](SearchRange range) {
    find_limits([](double) { return 0.0; }, range, std::array{0.01});
  };
  EXPECT_THROW(search({0, 1}), InputError);
  EXPECT_THROW(search({1, 1}), InputError);
  EXPECT_THROW(search({1, std::numeric_limits<double>::infinity()}), InputError);
  EXPECT_THROW(search({1, 2, 1}), InputError);
}

}  // namespace
}  // namespace warpgrain
