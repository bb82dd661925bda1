#include <gtest/gtest.h>

#include "core/reference_solver.hpp"
#include "core/scene.hpp"

namespace warpgrain {
namespace {

TEST(ReferenceSolver, HeadOnSceneKeepsItsRestitution) {
  const Scene scene = load_scene("head_on");
  ReferenceSolver<double> solver(scene);
  solver.step(3000);
  const ParticleState state = solver.state();
  EXPECT_NEAR(state.velocity[1].x(), 0.8, 2e-3);
  EXPECT_NEAR((state.velocity[0] + state.velocity[1]).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace warpgrain
