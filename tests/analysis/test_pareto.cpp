#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "analysis/pareto.hpp"
#include "core/error.hpp"

namespace warpgrain {
namespace {

bool at_most(const Costs& a, const Costs& b) {
  for (std::size_t k = 0; k < a.size(); ++k)
    if (a[k] > b[k]) return false;
  return true;
}

// By definition: what is named dominates, and what is on the front is dominated by nothing.
TEST(Pareto, FrontAndDominatedPartTheChoices) {
  constexpr unsigned seed = 11;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int repeat = 0; repeat < 200; ++repeat) {
    std::vector<Costs> choices(1 + random() % 12, Costs(1 + repeat % 3));
    for (Costs& costs : choices)
      for (double& cost : costs) cost = random() % 4;  // so that many tie
    const auto by = dominated_by(choices);
    ASSERT_EQ(by.size(), choices.size());
    EXPECT_TRUE(std::any_of(by.begin(), by.end(), [](const auto& d) { return !d; }));
    for (std::size_t k = 0; k < choices.size(); ++k) {
      if (by[k]) {
        EXPECT_TRUE(at_most(choices[*by[k]], choices[k]) && choices[*by[k]] != choices[k]);
        continue;
      }
      for (const Costs& other : choices) EXPECT_FALSE(at_most(other, choices[k]) && other != choices[k]);
    }
  }
}

TEST(Pareto, InfinityIsTheWorstAndNaNIsRefused) {
  const std::vector<Costs> choices{{1, INFINITY}, {1, 2}};
  EXPECT_EQ(dominated_by(choices)[0], 1U);
  EXPECT_FALSE(dominated_by(choices)[1]);
  EXPECT_THROW(dominated_by(std::vector<Costs>{{NAN}}), InputError);
  EXPECT_THROW(dominated_by(std::vector<Costs>{{1}, {1, 2}}), InputError);
}

}  // namespace
}  // namespace warpgrain
