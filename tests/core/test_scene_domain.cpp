#include <gtest/gtest.h>

#include "core/collision_grid.hpp"
#include "core/scene_domain.hpp"
#include "tests/core/example_scenes.hpp"

namespace warpgrain {
namespace {

Scene falling_sphere() {
  ExampleScene example;
  example.particles =
      R"([ { "material": "glass", "radius": 0.01, "position": [0, 0, 0.5], "velocity": [2, 0, 0] } ])";
  example.walls = R"([ { "material": "glass", "plane": { "point": [0, 0, 0], "normal": [0, 0, 1] } },
                       { "material": "glass", "rectangle": { "corner": [0.2, 0, 0], "edges": [[0, 0.1, 0], [0, 0, 0.3]] } } ])";
  Scene scene = example.scene();
  scene.time_step = 1e-3;
  scene.end = {};
  scene.end.steps = 100;
  return scene;
}

TEST(SceneDomain, BoxHoldsParticlesRectanglesAndPlanes) {
  const Box box = box_around(falling_sphere());
  EXPECT_EQ(box.lower, Vector3d(-0.01, -0.01, 0));
  EXPECT_EQ(box.upper, Vector3d(0.2, 0.1, 0.51));
}

TEST(SceneDomain, LeavesRoomForTravelButNotBehindPlanes) {
  const Box domain = derive_domain(falling_sphere());
  const double margin = 4 * 0.01 + 2 * 2 * 0.1;
  EXPECT_EQ(domain.lower.z(), 0);
  EXPECT_NEAR(domain.upper.z(), 0.51 + margin, 1e-12);
  EXPECT_NEAR(domain.lower.x(), -0.01 - margin, 1e-12);
}

TEST(SceneDomain, StaysWithinWhatAGridCanHold) {
  Scene scene = falling_sphere();
  scene.particles.velocity[0].x() = 1000;
  const Box domain = derive_domain(scene);
  const GridGeometry grid = make_grid_geometry(domain, 0.02, 1);
  EXPECT_LE(grid.cell_count(), std::size_t{1} << 21);
  EXPECT_EQ(grid.cell_edge, 0.02);
}

}  // namespace
}  // namespace warpgrain
