#include <gtest/gtest.h>

#include "core/reference_forces.hpp"
#include "core/simple_model.hpp"
#include "tests/core/example_scenes.hpp"

namespace warpgrain {
namespace {

TEST(SimpleModel, ForceIsEquationOne) {
  ExampleScene example;
  example.model = R"({ "contact": "simple", "simple": { "k_spring": 100, "k_damping": 2, "k_shear": 3 } })";
  example.particles = R"([
    { "material": "glass", "radius": 0.5, "position": [0, 0, 0], "velocity": [1, 4, 0], "angular_velocity": [0, 0, 9] },
    { "material": "glass", "radius": 0.25, "position": [0.5, 0, 0], "velocity": [0.5, 1, 0] } ])";
  const Scene scene = example.scene();
  const ForceEvaluation result = evaluate_forces(scene, scene.particles, 1e-4);
  // Overlap 0.25 along x, v = (0.5, 3, 0): spring -25, damping -2 v, shear -3 * (0, 3, 0).
  EXPECT_NEAR((result.forces.force[0] - Vector3d(-25 - 1, -6 - 9, 0)).norm(), 0, 1e-12);
  EXPECT_EQ(result.forces.force[1], -result.forces.force[0]);
  // No rotation, no memory.
  EXPECT_EQ(result.forces.torque[0], Vector3d(Vector3d::Zero()));
  EXPECT_TRUE(result.contact_history.empty());
  EXPECT_EQ(result.contact_count, 1u);
}

}  // namespace
}  // namespace warpgrain
