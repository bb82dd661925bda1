#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

#include "core/time_step.hpp"
#include "tests/core/example_scenes.hpp"

namespace warpgrain {
namespace {

TEST(TimeStep, LimitsAreTheClosedForms) {
  const Scene scene = head_on_impact(3, R"("restitution": 0.8, "friction": 0.5)").scene();
  const TimeStepLimits limits = time_step_limits(scene);
  EXPECT_NEAR(limits.rayleigh_time,
              std::numbers::pi * 0.005 * std::sqrt(2500 / (1e7 / 2.6)) / (0.1631 * 0.3 + 0.8766), 1e-15);
  EXPECT_NEAR(limits.impact_speed, 3, 1e-15);
  const double mass = scene.particles.mass[0] / 2, modulus = 1e7 / (2 * 0.91);
  EXPECT_NEAR(limits.hertz_contact_time, 2.87 * std::pow(mass * mass / (0.0025 * modulus * modulus * 3), 0.2),
              1e-12);
  EXPECT_DOUBLE_EQ(automatic_time_step(limits),
                   0.1 * std::min(limits.rayleigh_time, limits.hertz_contact_time));
}

TEST(TimeStep, FreeFallCountsAsAnImpact) {
  const Scene scene = load_scene("free_fall");
  EXPECT_NEAR(time_step_limits(scene).impact_speed, std::sqrt(2 * 9.81 * 0.11), 1e-3);
  // Onto a slope as well, which no box around the scene contains.
  ExampleScene slope;
  slope.gravity = "[0, 0, -10]";
  slope.particles = R"([ { "material": "glass", "radius": 0.01, "position": [0, 0, 0.5] } ])";
  slope.walls = R"([ { "material": "glass", "plane": { "point": [0, 0, -0.5], "normal": [1, 0, 1] } } ])";
  EXPECT_NEAR(time_step_limits(slope.scene()).impact_speed, std::sqrt(2 * 10 * 1.0), 1e-12);
}

TEST(TimeStep, WithoutMotionOnlyTheRayleighTimeLimits) {
  Scene scene = head_on_impact(0, R"("restitution": 0.8, "friction": 0.5)").scene();
  const TimeStepLimits limits = time_step_limits(scene);
  EXPECT_TRUE(std::isinf(limits.hertz_contact_time));
  EXPECT_DOUBLE_EQ(automatic_time_step(limits), 0.1 * limits.rayleigh_time);
}

TEST(TimeStep, WarnsAboveAFifthOfEither) {
  const TimeStepLimits limits{1e-4, 1e-3, 2};
  EXPECT_EQ(time_step_warning(1.9e-5, limits), "");
  EXPECT_THAT(time_step_warning(3e-5, limits), testing::HasSubstr("0.3 of the Rayleigh time"));
  EXPECT_THAT(time_step_warning(3e-5, {1, 1e-4, 2}),
              testing::HasSubstr("0.3 of the Hertz contact time at 2 m/s"));
}

}  // namespace
}  // namespace warpgrain
