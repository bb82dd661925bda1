#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "core/error.hpp"
#include "core/reference_solver.hpp"
#include "core/run_monitor.hpp"
#include "example_scenes.hpp"

namespace warpgrain {
namespace {

using testing::HasSubstr;

Scene touching_pair() { return head_on_impact(2, R"("restitution": 0.8, "friction": 0.5)").scene(); }

std::string refusal_of(const Scene& scene, const ParticleState& state) {
  RunMonitor monitor(scene);
  monitor.look(0, scene.particles);
  try {
    monitor.look(7, state);
  } catch (const SimulationError& error) {
    return error.what();
  }
  return "no refusal";
}

TEST(RunMonitor, SaysNothingOfACollision) {
  Scene scene = touching_pair();
  scene.time_step = 1e-5;
  RunMonitor monitor(scene);
  ReferenceSolver<double> solver(scene, {.threads = 1});
  for (int k = 0; k < 30; ++k) {
    EXPECT_THAT(monitor.look(solver.steps_done(), solver.state()), testing::IsEmpty());
    solver.step(10);
  }
  EXPECT_LT(monitor.energy().total(), energy_of(scene, scene.particles).total());
}

TEST(RunMonitor, NamesWhatIsNoNumberAndWhatIsLost) {
  const Scene scene = touching_pair();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  ParticleState state = scene.particles;
  state.angular_velocity[1].y() = nan;
  EXPECT_THAT(refusal_of(scene, state), HasSubstr("step 7: particle 1: has an angular velocity"));
  state = scene.particles;
  state.velocity[0].z() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal_of(scene, state), HasSubstr("step 7: particle 0: has a velocity"));
  state.position[0].x() = nan;
  EXPECT_THAT(refusal_of(scene, state), HasSubstr("step 7: particle 0: has a position"));
  state = scene.particles;
  state.position[1].x() = 2;
  EXPECT_THAT(refusal_of(scene, state), HasSubstr("step 7: particle 1: left the domain"));
}

TEST(RunMonitor, WarnsOfADeepOverlapOnceAndRefusesAComplete) {
  const Scene scene = touching_pair();
  MonitorLimits limits;
  limits.energy_error = limits.energy_warning = 1e300;
  RunMonitor monitor(scene, limits);
  ParticleState state = scene.particles;
  state.position[1].x() = state.position[0].x() + 0.008;  // two fifths of the radius
  const auto warnings = monitor.look(3, state);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], HasSubstr("step 3: particle 0 overlaps particle 1 by 0.4 of its radius"));
  EXPECT_THAT(monitor.look(4, state), testing::IsEmpty());
  state.position[1].x() = state.position[0].x() + 0.004;
  EXPECT_THROW(monitor.look(5, state), SimulationError);
}

TEST(RunMonitor, SeesEnergyThatNothingHasGiven) {
  const Scene scene = touching_pair();
  RunMonitor monitor(scene);
  monitor.look(0, scene.particles);
  ParticleState state = scene.particles;
  state.velocity[0] *= 1.1;  // a tenth of all energy more
  const auto warnings = monitor.look(9, state);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0], HasSubstr("step 9: particle 0 is the fastest"));
  state.velocity[0] *= 3;
  EXPECT_THAT(refusal_of(scene, state), HasSubstr("without a source"));
}

// A device's masses are floats: far from the origin that alone moves the energy of place by more than a
// sphere at rest has in its contact.
TEST(RunMonitor, TakesTheRoundingOfMassesForNoGrowth) {
  ExampleScene example;
  example.gravity = "[0, 0, -9.81]";
  example.domain = R"({ "lower": [-0.1, -0.1, 1000], "upper": [0.1, 0.1, 1000.2] })";
  example.particles = R"([{ "material": "glass", "radius": 0.001, "position": [0, 0, 1000.000999] }])";
  example.walls = R"([{ "material": "glass", "plane": { "point": [0, 0, 1000], "normal": [0, 0, 1] } }])";
  const Scene scene = example.scene();
  RunMonitor monitor(scene);
  monitor.look(0, scene.particles);
  ParticleState state = scene.particles;
  state.mass[0] *= 1 - 6e-8;
  EXPECT_THAT(monitor.look(1, state), testing::IsEmpty());
}

TEST(RunMonitor, CountsAFallAsNoGrowth) {
  Scene scene = load_scene("free_fall");
  RunMonitor monitor(scene);
  ReferenceSolver<double> solver(scene, {.threads = 1});
  for (int k = 0; k < 20; ++k) {
    EXPECT_THAT(monitor.look(solver.steps_done(), solver.state()), testing::IsEmpty());
    solver.step(200);
  }
}

}  // namespace
}  // namespace warpgrain
