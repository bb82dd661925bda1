#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/reference_solver.hpp"
#include "core/time_step_advice.hpp"
#include "example_scenes.hpp"

namespace warpgrain {
namespace {

using testing::HasSubstr;

Scene automatic(double restitution) {
  ExampleScene example = head_on_impact(1, fmt::format(R"("restitution": {}, "friction": 0.5)", restitution));
  Scene scene = example.scene();
  scene.time_step = advise_time_step(scene, time_step_limits(scene)).step;
  return scene;
}

TEST(TimeStepAdvice, ErrorsShrinkWithTheStep) {
  for (double restitution : {1.0, 0.8, 0.5, 0.2, 0.05}) {
    EXPECT_LT(restitution_error(restitution, 0.01), 0.04) << restitution;
    EXPECT_LT(restitution_error(restitution, 0.001), restitution_error(restitution, 0.1)) << restitution;
  }
}

TEST(TimeStepAdvice, KeepsATenthWhereThatIsRight) {
  const Scene scene = automatic(0.8);
  const TimeStepLimits limits = time_step_limits(scene);
  EXPECT_EQ(scene.time_step, automatic_time_step(limits));
  EXPECT_THAT(advise_time_step(scene, limits).reason, HasSubstr("restitution comes out right"));
}

TEST(TimeStepAdvice, TakesSmallerStepsWhereATenthIsNotAndSaysSo) {
  const Scene scene = automatic(0.4);
  const TimeStepLimits limits = time_step_limits(scene);
  const TimeStepAdvice advice = advise_time_step(scene, limits);
  EXPECT_LT(advice.step, automatic_time_step(limits));
  EXPECT_LE(advice.restitution_error, 0.01);
  EXPECT_THAT(advice.reason, HasSubstr("would put a restitution of 0.4 off by"));
}

// What the advice promises, seen in the reference solver.
TEST(TimeStepAdvice, KeepsRestitutionWithinOnePercent) {
  for (double restitution : {1.0, 0.8, 0.6, 0.4, 0.2, 0.1}) {
    const Scene scene = automatic(restitution);
    ReferenceSolver<double> solver(scene, {.threads = 1});
    const auto apart = [&] {
      const ParticleState state = solver.state();
      return (state.position[1] - state.position[0]).norm() > 0.01 &&
             state.velocity[1].x() > state.velocity[0].x();
    };
    for (int k = 0; k < 200 && !apart(); ++k) solver.step(20);
    const ParticleState after = solver.state();
    EXPECT_NEAR(after.velocity[1].x() - after.velocity[0].x(), restitution, 0.0101 * restitution);
  }
}

TEST(TimeStepAdvice, SaysNothingOfRestitutionWhereNothingMeets) {
  Scene scene = automatic(0.4);
  scene.particles.velocity[0].setZero();
  scene.particles.velocity[1].setZero();
  EXPECT_EQ(advise_time_step(scene, time_step_limits(scene)).reason, "0.1 of the Rayleigh time");
}

}  // namespace
}  // namespace warpgrain
