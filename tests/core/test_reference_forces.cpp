#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/reference_forces.hpp"
#include "tests/core/example_scenes.hpp"

namespace warpgrain {
namespace {

constexpr double stiffness = 7.326007326007326e6;  // C_kn of the examples' material

ExampleScene resting_sphere(const std::string& position, const std::string& walls) {
  ExampleScene example;
  example.particles =
      fmt::format(R"([ {{ "material": "glass", "radius": 0.1, "position": {} }} ])", position);
  example.walls = walls;
  return example;
}

ForceEvaluation evaluated(const ExampleScene& example) {
  const Scene scene = example.scene();
  return evaluate_forces(scene, scene.particles, 1e-6);
}

Vector3d spring_force(double overlap, const Vector3d& direction) {
  return direction.normalized() * stiffness * std::sqrt(0.1 * overlap) * overlap;
}

void expect_force(const ExampleScene& example, const Vector3d& expected) {
  const ForceEvaluation result = evaluated(example);
  EXPECT_EQ(result.contact_count, 1u);
  EXPECT_NEAR((result.forces.force[0] - expected).norm(), 0, 1e-12 * expected.norm())
      << result.forces.force[0];
}

const std::string square =
    R"([ { "material": "glass", "rectangle": { "corner": [0, 0, 0], "edges": [[1, 0, 0], [0, 1, 0]] } } ])";

TEST(ReferenceForces, FaceEdgeAndCornerOfARectangle) {
  expect_force(resting_sphere("[0.5, 0.5, 0.09]", square), spring_force(0.01, Vector3d::UnitZ()));
  expect_force(resting_sphere("[0.5, 0.5, -0.09]", square), spring_force(0.01, -Vector3d::UnitZ()));
  expect_force(resting_sphere("[-0.03, 0.5, 0.04]", square), spring_force(0.05, Vector3d(-3, 0, 4)));
  expect_force(resting_sphere("[-0.02, -0.04, 0.04]", square), spring_force(0.04, Vector3d(-1, -2, 2)));
}

TEST(ReferenceForces, RectanglesThatMeetAreTwoPartners) {
  // On the joint of two coplanar rectangles the sphere feels both.
  const std::string halves = R"([
    { "material": "glass", "rectangle": { "corner": [-1, -1, 0], "edges": [[1, 0, 0], [0, 2, 0]] } },
    { "material": "glass", "rectangle": { "corner": [0, -1, 0], "edges": [[1, 0, 0], [0, 2, 0]] } } ])";
  const ForceEvaluation result = evaluated(resting_sphere("[0, 0, 0.09]", halves));
  EXPECT_EQ(result.contact_count, 2u);
  EXPECT_NEAR(result.forces.force[0].z(), 2 * spring_force(0.01, Vector3d::UnitZ()).z(), 1e-9);
  ASSERT_EQ(result.contact_history.size(), 2u);
  EXPECT_EQ(result.contact_history[0].partner_id, wall_partner_bit);
  EXPECT_EQ(result.contact_history[1].partner_id, wall_partner_bit | 1);
}

TEST(ReferenceForces, SlidingTurnsBothBodiesTheSameWay) {
  ExampleScene example;
  example.particles = R"([
    { "material": "glass", "radius": 0.1, "position": [0, 0, 0], "velocity": [0, 1, 0] },
    { "material": "glass", "radius": 0.05, "position": [0.149, 0, 0] } ])";
  example.contact = R"("damping_parameter": 0, "friction": 10)";
  const ForceEvaluation result = evaluated(example);
  const Vector3d force = result.forces.force[0];
  // Friction holds the upper body back; n x F_t, eq. (3), with each body's own radius.
  EXPECT_LT(force.y(), 0);
  EXPECT_NEAR(result.forces.torque[0].z(), 0.1 * force.y(), 1e-12 * std::abs(force.y()));
  EXPECT_NEAR(result.forces.torque[1].z(), 0.05 * force.y(), 1e-12 * std::abs(force.y()));
  EXPECT_EQ(result.forces.force[1], -force);
  // Both directions of the pair are in the history.
  ASSERT_EQ(result.contact_history.size(), 2u);
  EXPECT_NEAR(result.contact_history[0].tangential_displacement.y(), 1e-6, 1e-18);
  EXPECT_EQ(result.contact_history[1].tangential_displacement,
            Vector3d(-result.contact_history[0].tangential_displacement));
}

TEST(ReferenceForces, RollingWithoutSlipHasNoTangentialForce) {
  ExampleScene example = resting_sphere("[0.5, 0.5, 0.1]", square);
  Scene scene = example.scene();
  scene.particles.position[0].z() = 0.09;
  scene.particles.velocity[0] = {1, 0, 0};
  scene.particles.angular_velocity[0] = {0, 1 / 0.1, 0};
  const ForceEvaluation result = evaluate_forces(scene, scene.particles, 1e-6);
  EXPECT_NEAR(result.forces.torque[0].norm(), 0, 1e-12);
}

// A bed of two radii with some rotation and history.
ParticleState moving_bed(Scene& scene) {
  scene = loose_bed(2000, 5);
  for (std::size_t k = 0; k < scene.particles.size(); k += 3) {
    scene.particles.radius[k] *= 0.8;
    scene.particles.mass[k] *= 0.8 * 0.8 * 0.8;
  }
  ReferenceSolver<double> solver(scene);
  solver.step(1500);
  return solver.state();
}

TEST(ReferenceForces, KeepTheOrderOfTheState) {
  Scene scene;
  const ParticleState state = moving_bed(scene);
  ParticleState reversed = state;
  for (auto* array : {&reversed.id, &reversed.material}) std::reverse(array->begin(), array->end());
  for (auto* array : {&reversed.radius, &reversed.mass}) std::reverse(array->begin(), array->end());
  for (auto* array : {&reversed.position, &reversed.velocity, &reversed.angular_velocity})
    std::reverse(array->begin(), array->end());
  const ForceEvaluation a = evaluate_forces(scene, state, scene.time_step);
  ForceEvaluation b = evaluate_forces(scene, reversed, scene.time_step);
  std::reverse(b.forces.force.begin(), b.forces.force.end());
  EXPECT_GT(a.contact_count, 1000u);
  EXPECT_EQ(a.forces.force, b.forces.force);
}

TEST(ReferenceForces, AreThoseOfTheSolverThatMadeTheState) {
  Scene scene = loose_bed(2000);
  ReferenceSolver<double> solver(scene);
  solver.step(700);
  const ForceEvaluation result = evaluate_forces(scene, solver.state(), scene.time_step);
  EXPECT_EQ(result.forces.force, solver.forces().force);
  EXPECT_EQ(result.forces.torque, solver.forces().torque);
  EXPECT_EQ(result.contact_count, solver.contact_count());
}

TEST(ReferenceForces, FloatAgreesWithDouble) {
  Scene scene;
  scene.particles = moving_bed(scene);
  const ReferenceSolver<float> single(scene);
  const ForceEvaluation reference = evaluate_forces(scene, scene.particles, scene.time_step);
  double error = 0, scale = 0;
  for (std::size_t k = 0; k < reference.forces.force.size(); ++k) {
    error += (single.forces().force[k] - reference.forces.force[k]).squaredNorm();
    scale += reference.forces.force[k].squaredNorm();
  }
  // An overlap of some 1e-5 m is the difference of coordinates of some 0.1 m, of which float keeps 4e-9 m.
  EXPECT_LT(std::sqrt(error / scale), 2e-3);
  EXPECT_GT(error, 0);
}

}  // namespace
}  // namespace warpgrain
