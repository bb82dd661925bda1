#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "analysis/convergence.hpp"
#include "core/error.hpp"

namespace warpgrain {
namespace {

TEST(Convergence, FindsTheOrder) {
  for (const double order : {0.5, 1.0, 2.0, 3.0}) {
    std::array<double, 12> results;
    for (std::size_t k = 0; k < results.size(); ++k) results[k] = 7 + 3 * std::exp2(-order * double(k));
    results.back() = 7;
    EXPECT_NEAR(*convergence_order(results), order, 1e-9);
  }
}

TEST(Convergence, HasNoneWhereNothingChangesAndRefusesWhatIsNoNumber) {
  EXPECT_FALSE(convergence_order(std::array{1.0, 1.0, 1.0}));
  EXPECT_THROW(convergence_order(std::array{1.0, 2.0}), InputError);
  EXPECT_THROW(convergence_order(std::array{1.0, double{NAN}, 2.0}), InputError);
}

}  // namespace
}  // namespace warpgrain
