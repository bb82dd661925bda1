#include <gtest/gtest.h>

#include "core/rest_criterion.hpp"

namespace warpgrain {
namespace {

std::vector<Vector3d> places(double x) { return {Vector3d(0, 0, 0), Vector3d(x, 0, 0)}; }

TEST(RestCriterion, NeedsAWholeWindowWithoutMotion) {
  RestCriterion rest({0.1, 100}, 0, places(0));
  EXPECT_FALSE(rest.update(50, places(0.05)));
  EXPECT_FALSE(rest.update(99, places(0.1)));
  EXPECT_TRUE(rest.update(100, places(0.1)));
}

TEST(RestCriterion, AMoveBeginsANewWindow) {
  RestCriterion rest({0.1, 100}, 0, places(0));
  EXPECT_FALSE(rest.update(90, places(0.2)));
  EXPECT_NEAR(rest.displacement(), 0.2, 1e-15);
  EXPECT_FALSE(rest.update(100, places(0.2)));
  EXPECT_FALSE(rest.update(189, places(0.25)));
  EXPECT_TRUE(rest.update(190, places(0.25)));
}

TEST(RestCriterion, SlowCreepIsNoRest) {
  RestCriterion rest({0.1, 100}, 0, places(0));
  for (int k = 1; k <= 1000; ++k) EXPECT_FALSE(rest.update(10 * k, places(0.02 * k)));
}

}  // namespace
}  // namespace warpgrain
