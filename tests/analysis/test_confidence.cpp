#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "analysis/confidence.hpp"
#include "core/error.hpp"

namespace warpgrain {
namespace {

// t of 0.975 with 4 degrees of freedom is 2.776 (any table).
TEST(Confidence, IntervalOfAMeanIsStudents) {
  const std::array values{1.0, 2.0, 3.0, 4.0, 5.0};
  const MeanInterval interval = mean_interval(values);
  EXPECT_DOUBLE_EQ(interval.mean, 3);
  EXPECT_NEAR(*interval.half_width, 2.776 * std::sqrt(2.5 / 5), 1e-3);
}

TEST(Confidence, OneValueHasNoInterval) {
  const std::array one{2.0};
  EXPECT_FALSE(mean_interval(one).half_width);
  EXPECT_FALSE(is_significant(difference_of_means(one, std::array{3.0})));
  EXPECT_THROW(mean_interval({}), InputError);
  EXPECT_THROW(mean_interval(std::array{double{NAN}}), InputError);
}

TEST(Confidence, EqualValuesDifferByNothing) {
  const std::array a{1.0, 1.0, 1.0};
  const std::array b{2.0, 2.0};
  EXPECT_FALSE(is_significant(difference_of_means(a, a)));
  EXPECT_TRUE(is_significant(difference_of_means(a, b)));
}

// Of samples of one distribution about one in twenty may be taken for different; of distributions three
// deviations apart nearly none for equal.
TEST(Confidence, ClaimsDifferencesAsOftenAsItSays) {
  constexpr unsigned seed = 3;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  int false_claims = 0, true_claims = 0;
  constexpr int repeats = 2000;
  for (int k = 0; k < repeats; ++k) {
    std::array<double, 6> a, b, c;
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] = normal(random);
      b[i] = normal(random);
      c[i] = 3 + normal(random);
    }
    false_claims += is_significant(difference_of_means(a, b));
    true_claims += is_significant(difference_of_means(a, c));
  }
  EXPECT_NEAR(false_claims / double{repeats}, 0.05, 0.02);
  EXPECT_GT(true_claims / double{repeats}, 0.98);
}

// t of 1 - 0.025 / 10 with 8 degrees of freedom is 3.833 (any table).
TEST(Confidence, ManyComparisonsWidenTheIntervalOfEach) {
  const std::array a{1.0, 2.0, 3.0, 4.0, 5.0}, b{2.0, 3.0, 4.0, 5.0, 6.0};
  EXPECT_NEAR(*difference_of_means(a, b, 10).half_width, 3.833 * std::sqrt(2 * 2.5 / 5), 1e-3);
}

}  // namespace
}  // namespace warpgrain
