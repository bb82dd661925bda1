#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <random>

#include "core/energy.hpp"
#include "core/error.hpp"
#include "core/reference_solver.hpp"
#include "tests/core/example_scenes.hpp"

namespace warpgrain {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

// Two particles closing at `speed`, with what Hertz's theory says of their elastic impact.
struct Impact {
  double speed, max_overlap, contact_time;
};

Impact hertz_impact(const Scene& scene, double speed) {
  const double effective_radius = scene.particles.radius[0] / 2, effective_mass = scene.particles.mass[0] / 2;
  const double normal_parameter = scene.contacts.at(0, 0).normal_parameter;
  // m* v^2 / 2 = 2/5 C_kn sqrt(R*) overlap^2.5; the time is overlap / v times 2 int_0^1 dx / sqrt(1 - x^2.5).
  const double overlap =
      std::pow(1.25 * effective_mass * speed * speed / (normal_parameter * std::sqrt(effective_radius)), 0.4);
  return {speed, overlap, 2.9432750 * overlap / speed};
}

Scene impact_scene(double speed, double restitution, double share_of_contact_time) {
  ExampleScene example =
      head_on_impact(speed, fmt::format(R"("restitution": {}, "friction": 0.5)", restitution));
  example.step = share_of_contact_time * hertz_impact(example.scene(), speed).contact_time;
  Scene scene = example.scene();
  scene.particles.position[1].x() = 0.01 + 1e-9;  // about to touch
  return scene;
}

double restitution_of(const Scene& scene, double speed) {
  ReferenceSolver<double> solver(scene);
  while (solver.contact_count() == 0) solver.step();
  while (solver.contact_count() > 0) solver.step();
  const ParticleState state = solver.state();
  return (state.velocity[1].x() - state.velocity[0].x()) / speed;
}

TEST(ReferenceSolver, ImpactsHaveTheStatedRestitutionAtAnySpeed) {
  for (double restitution : {1.0, 0.8, 0.5})
    for (double speed : {0.1, 2.0})
      EXPECT_NEAR(restitution_of(impact_scene(speed, restitution, 0.0005), speed), restitution, 2e-3)
          << "at " << speed << " m/s";
}

TEST(ReferenceSolver, ElasticImpactFollowsHertzTheory) {
  const Scene scene = impact_scene(2, 1, 0.0001);
  const Impact theory = hertz_impact(scene, 2);
  ReferenceSolver<double> solver(scene);
  while (solver.contact_count() == 0) solver.step();
  double max_overlap = 0;
  const std::uint64_t first = solver.steps_done();
  while (solver.contact_count() > 0) {
    const ParticleState state = solver.state();
    max_overlap = std::max(max_overlap, 0.01 - (state.position[1] - state.position[0]).norm());
    solver.step();
  }
  const double contact_time = static_cast<double>(solver.steps_done() - first) * scene.time_step;
  EXPECT_NEAR(max_overlap / theory.max_overlap, 1, 1e-3);
  EXPECT_NEAR(contact_time / theory.contact_time, 1, 1e-3);
}

TEST(ReferenceSolver, MomentumIsKeptToRounding) {
  Scene scene = loose_bed(500);
  scene.walls.clear();
  scene.gravity.setZero();
  scene.domain = {Vector3d::Constant(-1), Vector3d::Constant(1)};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> speed(-1, 1);
  for (Vector3d& v : scene.particles.velocity) v = {speed(random), speed(random), speed(random)};
  const auto momentum = [](const ParticleState& state) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t k = 0; k < state.size(); ++k) sum += state.mass[k] * state.velocity[k];
    return sum;
  };
  double scale = 0;
  for (std::size_t k = 0; k < scene.particles.size(); ++k)
    scale += scene.particles.mass[k] * scene.particles.velocity[k].norm();
  ReferenceSolver<double> solver(scene);
  std::uint64_t contacts = 0;
  for (int k = 0; k < 50; ++k) {
    solver.step(20);
    contacts += solver.contact_count();
  }
  EXPECT_GT(contacts, 1000u);
  EXPECT_LT((momentum(solver.state()) - momentum(scene.particles)).norm(), 1e-13 * scale);
}

double spin_after_oblique_impact(SlipHistory rule) {
  Scene scene = load_scene("oblique_wall");
  scene.model.slip_history = rule;
  ReferenceSolver<double> solver(scene);
  solver.step(static_cast<std::uint64_t>(*scene.end.time / scene.time_step));
  EXPECT_EQ(solver.contact_count(), 0u);
  EXPECT_GT(solver.state().velocity[0].z(), 3);
  return solver.state().angular_velocity[0].y();
}

TEST(ReferenceSolver, ObliqueImpactSpinsAsPublished) {
  EXPECT_NEAR(spin_after_oblique_impact(SlipHistory::clip), 378, 0.05 * 378);
  EXPECT_NEAR(spin_after_oblique_impact(SlipHistory::paper), 643, 0.02 * 643);
  EXPECT_NEAR(spin_after_oblique_impact(SlipHistory::lammps), 370, 0.02 * 370);
}

TEST(ReferenceSolver, FollowsAFallFromRest) {
  ExampleScene example;
  example.gravity = "[0, 0, -10]";
  example.particles = R"([ { "material": "glass", "radius": 0.005, "position": [0, 0, 0.5] } ])";
  example.step = 1e-3;
  ReferenceSolver<double> solver(example.scene());
  solver.step(100);
  // Semi-implicit Euler: x = -g dt^2 n (n + 1) / 2.
  EXPECT_NEAR(solver.state().position[0].z(), 0.5 - 10 * 1e-6 * 100 * 101 / 2, 1e-14);
  EXPECT_NEAR(solver.state().velocity[0].z(), -1, 1e-14);
}

void expect_same_bits(const ParticleState& a, const ParticleState& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.angular_velocity, b.angular_velocity);
  ASSERT_EQ(a.contact_history.size(), b.contact_history.size());
  for (std::size_t k = 0; k < a.contact_history.size(); ++k) {
    EXPECT_EQ(a.contact_history[k].particle_id, b.contact_history[k].particle_id);
    EXPECT_EQ(a.contact_history[k].partner_id, b.contact_history[k].partner_id);
    EXPECT_EQ(a.contact_history[k].tangential_displacement, b.contact_history[k].tangential_displacement);
  }
}

template <class Real>
class ReferenceSolverOf : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(ReferenceSolverOf, Reals);

TYPED_TEST(ReferenceSolverOf, SameBitsAtEveryRunAndForEveryNumberOfThreads) {
  const Scene scene = loose_bed(6000);
  ReferenceSolver<TypeParam> one(scene, {1, 16}), again(scene, {1, 16}), four(scene, {4, 16});
  for (auto* solver : {&one, &again, &four}) solver->step(400);
  EXPECT_GT(one.contact_count(), 1000u);
  expect_same_bits(one.state(), again.state());
  expect_same_bits(one.state(), four.state());
  EXPECT_EQ(one.forces().force, four.forces().force);
}

TYPED_TEST(ReferenceSolverOf, HistoryFollowsIdsThroughAPermutation) {
  const Scene scene = loose_bed(3000);
  ReferenceSolver<TypeParam> straight(scene);
  straight.step(600);
  // The same state, its particles in another order, handed to a new solver.
  const ParticleState state = straight.state();
  EXPECT_FALSE(state.contact_history.empty());
  Scene shuffled = scene;
  ParticleState& p = shuffled.particles = state;
  std::vector<std::size_t> order(state.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  for (std::size_t k = 0; k < order.size(); ++k) {
    p.id[k] = state.id[order[k]];
    p.position[k] = state.position[order[k]];
    p.velocity[k] = state.velocity[order[k]];
    p.angular_velocity[k] = state.angular_velocity[order[k]];
  }
  ReferenceSolver<TypeParam> resumed(shuffled);
  EXPECT_EQ(resumed.forces().force, straight.forces().force);
  straight.step(100);
  resumed.step(100);
  expect_same_bits(straight.state(), resumed.state());
}

TEST(ReferenceSolver, NeighbourListNeverMissesAContact) {
  const Scene scene = loose_bed(1000);
  ReferenceSolver<double> solver(scene);
  for (int k = 0; k < 40; ++k) {
    solver.step(25);
    Scene fresh = scene;
    fresh.particles = solver.state();
    EXPECT_EQ(ReferenceSolver<double>(fresh).contact_count(), solver.contact_count()) << "at " << k;
  }
  EXPECT_GT(solver.neighbour_list_builds(), 3u);
  EXPECT_LT(solver.neighbour_list_builds(), 500u);
}

TEST(ReferenceSolver, DissipatesEnergyButNeverGainsIt) {
  const Scene scene = loose_bed(1000);
  ReferenceSolver<double> solver(scene);
  double last = energy_of(scene, solver.state()).total();
  for (int k = 0; k < 20; ++k) {
    solver.step(100);
    const double now = energy_of(scene, solver.state()).total();
    EXPECT_LT(now, last);
    last = now;
  }
}

ExampleScene lone_particle(const char* velocity) {
  ExampleScene example;
  example.particles = fmt::format(
      R"([ {{ "material": "glass", "radius": 0.005, "position": [0, 0, 0.9], "velocity": {} }} ])", velocity);
  example.step = 0.01;
  return example;
}

TEST(ReferenceSolver, NamesTheParticleThatLeavesTheDomain) {
  ReferenceSolver<double> solver(lone_particle("[0, 0, 3]").scene());
  EXPECT_THAT(
      [&] { solver.step(10); },
      ThrowsMessage<SimulationError>("step 4: particle 0: left the domain, at (0, 0, 1.02); expected a place "
                                     "between (-1, -1, -1) and (1, 1, 1)"));
}

TEST(ReferenceSolver, NamesTheParticleThatTurnsNan) {
  Scene scene = lone_particle("[0, 0, 0]").scene();
  scene.particles.velocity[0].x() = std::numeric_limits<double>::quiet_NaN();
  ReferenceSolver<double> solver(scene);
  EXPECT_THAT([&] { solver.step(); },
              ThrowsMessage<SimulationError>(HasSubstr("step 1: particle 0: left the domain, at (nan")));

  scene = lone_particle("[0, 0, 0]").scene();
  scene.gravity.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT([&] { ReferenceSolver<double>{scene}; },
              ThrowsMessage<SimulationError>(HasSubstr("step 0: particle 0: force (nan")));
}

TEST(ReferenceSolver, NamesTheParticleThatRunsOutOfSlots) {
  ExampleScene example;
  example.particles = R"([
    { "material": "glass", "radius": 0.1, "position": [0, 0, 0] },
    { "material": "glass", "radius": 0.1, "position": [0.19, 0, 0] },
    { "material": "glass", "radius": 0.1, "position": [-0.19, 0, 0] } ])";
  example.walls = R"([ { "material": "glass", "plane": { "point": [0, 0, -0.09], "normal": [0, 0, 1] } } ])";
  const Scene scene = example.scene();
  EXPECT_EQ(ReferenceSolver<double>(scene, {1, 3}).contact_count(), 5u);
  EXPECT_THAT(
      [&] {
        ReferenceSolver<double>(scene, {1, 2});
      },
      ThrowsMessage<SimulationError>(
          "step 0: particle 0: 3 contacts at once; expected at most 2 (contact slots)"));
}

TEST(ReferenceSolver, NamesParticlesOnOneAnother) {
  Scene scene = head_on_impact(1, R"("restitution": 1, "friction": 0)").scene();
  scene.particles.position[1] = scene.particles.position[0];
  EXPECT_THAT([&] { ReferenceSolver<double>{scene}; },
              ThrowsMessage<SimulationError>(HasSubstr("particle 0: its centre lies on that of particle 1")));
}

TEST(ReferenceSolver, RefusesHistoryOfUnknownParticles) {
  Scene scene = head_on_impact(1, R"("restitution": 1, "friction": 0)").scene();
  scene.particles.contact_history = {{0, 7, Vector3d::Zero()}};
  EXPECT_THROW(ReferenceSolver<double>{scene}, InputError);
  scene.particles.contact_history = {{7, wall_partner_bit, Vector3d::Zero()}};
  EXPECT_THROW(ReferenceSolver<double>{scene}, InputError);
  scene.particles.contact_history = {{1, 0, Vector3d::Zero()}, {0, 1, Vector3d::Zero()}};
  EXPECT_THROW(ReferenceSolver<double>{scene}, InputError);
}

}  // namespace
}  // namespace warpgrain
