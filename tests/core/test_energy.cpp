#include <cmath>
#include <gtest/gtest.h>

#include "core/energy.hpp"
#include "core/reference_solver.hpp"
#include "tests/core/example_scenes.hpp"

namespace warpgrain {
namespace {

TEST(Energy, OfOneMovingParticle) {
  ExampleScene example;
  example.gravity = "[0, 0, -10]";
  example.particles =
      R"([ { "material": "glass", "radius": 0.1, "position": [0, 0, 0.5], "velocity": [3, 0, 4],
                             "angular_velocity": [0, 2, 0] } ])";
  const Scene scene = example.scene();
  const double mass = scene.particles.mass[0];
  const Energy energy = energy_of(scene, scene.particles);
  EXPECT_DOUBLE_EQ(energy.kinetic_translational, mass * 12.5);
  EXPECT_DOUBLE_EQ(energy.kinetic_rotational, 0.4 * mass * 0.01 * 2);
  EXPECT_DOUBLE_EQ(energy.gravitational, mass * 10 * 0.5);
  EXPECT_EQ(energy.elastic_normal, 0);
}

// The work of the spring is what the motion loses.
TEST(Energy, IsKeptInAnElasticImpact) {
  ExampleScene example = head_on_impact(2, R"("restitution": 1, "friction": 0.5)");
  example.step = 1e-7;
  const Scene scene = example.scene();
  ReferenceSolver<double> solver(scene);
  const double before = energy_of(scene, solver.state()).total();
  double elastic_normal = 0;
  for (int k = 0; k < 200; ++k) {
    solver.step(100);
    const Energy energy = energy_of(scene, solver.state());
    EXPECT_NEAR(energy.total(), before, 1e-3 * before);
    elastic_normal = std::max(elastic_normal, energy.elastic_normal);
  }
  EXPECT_GT(elastic_normal, 0.99 * before);
  EXPECT_EQ(solver.contact_count(), 0u);
}

TEST(Energy, OfTheTangentialSprings) {
  ExampleScene example;
  example.particles = R"([ { "material": "glass", "radius": 0.1, "position": [0, 0, 0] },
                           { "material": "glass", "radius": 0.1, "position": [0.19, 0, 0] },
                           { "material": "glass", "radius": 0.1, "position": [0.19, 0.3, 0] } ])";
  example.walls = R"([ { "material": "glass", "plane": { "point": [0, 0, -0.09], "normal": [0, 0, 1] } } ])";
  Scene scene = example.scene();
  const Vector3d pair(0, 0.001, 0), wall(0.002, 0, 0);
  scene.particles.contact_history = {{0, 1, pair}, {0, wall_partner_bit, wall}, {1, 0, -pair}};
  const double parameter = scene.contacts.at(0, 0).tangential_parameter;
  EXPECT_NEAR(energy_of(scene, scene.particles).elastic_tangential,
              parameter * (std::sqrt(0.01 * 0.05) * 1e-6 + std::sqrt(0.01 * 0.1) * 4e-6) / 2,
              1e-12 * parameter);
}

TEST(Energy, OfTheSimpleModelsSpring) {
  ExampleScene example;
  example.model = R"({ "contact": "simple", "simple": { "k_spring": 100, "k_damping": 0, "k_shear": 0 } })";
  example.particles = R"([ { "material": "glass", "radius": 0.5, "position": [0, 0, 0] },
                           { "material": "glass", "radius": 0.25, "position": [0.5, 0, 0] } ])";
  const Scene scene = example.scene();
  EXPECT_DOUBLE_EQ(energy_of(scene, scene.particles).elastic_normal, 100 * 0.25 * 0.25 / 2);
}

}  // namespace
}  // namespace warpgrain
