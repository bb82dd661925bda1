#include <cmath>
#include <gtest/gtest.h>

#include "core/practical_model.hpp"

namespace warpgrain {
namespace {

using Batch = ContactBatch<double>;

// One contact with round numbers: n along x, k_n = 8, k_t = 6, eta = 2, v_t and delta_t along y.
Batch one_contact(double displacement, double tangential_velocity, double friction) {
  Batch c;
  c.size = 1;
  c.overlap[0] = 0.5;
  c.effective_radius[0] = 2;  // sqrt(overlap R*) = 1
  c.effective_mass[0] = 0.5;
  c.contact_normal.row(0) << 1, 0, 0;
  c.normal_velocity[0] = 0.25;
  c.tangential_velocity.row(0) << 0, tangential_velocity, 0;
  c.tangential_displacement.row(0) << 0, displacement, 0;
  c.normal_parameter[0] = 8;
  c.tangential_parameter[0] = 6;
  c.damping_parameter[0] = 1;  // eta = sqrt(8 * 0.5) = 2
  c.friction_coefficient[0] = friction;
  return c;
}

ForceTermList<double> practical(SlipHistory slip_history, NormalForce normal_force = NormalForce::signed_) {
  ModelOptions options;
  options.slip_history = slip_history;
  options.normal_force = normal_force;
  ForceTermList<double> terms;
  add_practical_model(terms, options);
  return terms;
}

constexpr double normal_force = -8 * 0.5 - 2 * 0.25;  // eq. (4)

TEST(PracticalModel, SticksBelowTheLimit) {
  for (auto rule : {SlipHistory::clip, SlipHistory::paper, SlipHistory::lammps, SlipHistory::liggghts}) {
    Batch c = one_contact(0.1, 0.5, 10);
    practical(rule).apply(c, 0.2);
    EXPECT_DOUBLE_EQ(c.normal_force[0], normal_force);
    EXPECT_DOUBLE_EQ(c.tangential_displacement(0, 1), 0.1 + 0.5 * 0.2);  // eq. (7)
    EXPECT_DOUBLE_EQ(c.tangential_force(0, 1), -6 * 0.2 - 2 * 0.5);
  }
}

TEST(PracticalModel, ProjectsTheHistoryOnTheContactPlane) {
  Batch c = one_contact(0.1, 0.5, 10);
  c.tangential_displacement.row(0) << 0.3, 0.1, 0;
  practical(SlipHistory::clip).apply(c, 0.2);
  EXPECT_DOUBLE_EQ(c.tangential_displacement(0, 0), 0);
  EXPECT_DOUBLE_EQ(c.tangential_displacement(0, 1), 0.2);
}

// Sliding: delta_t becomes 0.2, F_t = -1.2 - 1 = -2.2; the limit is 0.2 * 4.5 = 0.9.
struct SlipCase {
  SlipHistory rule;
  double force, displacement;
};

class PracticalModelSlip : public testing::TestWithParam<SlipCase> {};

TEST_P(PracticalModelSlip, CutsTheForceAndSetsTheHistory) {
  Batch c = one_contact(0.1, 0.5, 0.2);
  practical(GetParam().rule).apply(c, 0.2);
  EXPECT_DOUBLE_EQ(c.tangential_force(0, 1), GetParam().force);
  EXPECT_NEAR(c.tangential_displacement(0, 1), GetParam().displacement, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(AllRules, PracticalModelSlip,
                         testing::Values(SlipCase{SlipHistory::clip, -0.9, 0.9 / 6},
                                         SlipCase{SlipHistory::paper, -0.9, 0.2},
                                         SlipCase{SlipHistory::lammps, -0.9, -(-0.9 + 2 * 0.5) / 6},
                                         SlipCase{SlipHistory::liggghts, -0.9, 0.9 / 6}));

TEST(PracticalModel, LiggghtsTestsTheSpringAlone) {
  // The spring is below the limit of 1.8, spring and damping together are above it.
  Batch liggghts = one_contact(0.1, 0.5, 0.4), clip = one_contact(0.1, 0.5, 0.4);
  practical(SlipHistory::liggghts).apply(liggghts, 0.2);
  practical(SlipHistory::clip).apply(clip, 0.2);
  EXPECT_DOUBLE_EQ(liggghts.tangential_force(0, 1), -2.2);
  EXPECT_DOUBLE_EQ(clip.tangential_force(0, 1), -1.8);
}

TEST(PracticalModel, SlipWithoutATangentialSpringStaysFinite) {
  Batch c = one_contact(0.1, 0.5, 0.01);
  c.tangential_parameter[0] = 0;
  practical(SlipHistory::clip).apply(c, 0.2);
  EXPECT_DOUBLE_EQ(c.tangential_force(0, 1), -0.045);
  EXPECT_DOUBLE_EQ(c.tangential_displacement(0, 1), 0.2);
}

TEST(PracticalModel, OnlyTheSignedForceMayPull) {
  Batch pulling = one_contact(0, 0.5, 0.5), repulsive = one_contact(0, 0.5, 0.5);
  pulling.normal_velocity[0] = repulsive.normal_velocity[0] =
      -3;  // parting: damping pulls with 6, the spring pushes 4
  practical(SlipHistory::clip).apply(pulling, 0.2);
  practical(SlipHistory::clip, NormalForce::repulsive).apply(repulsive, 0.2);
  EXPECT_DOUBLE_EQ(pulling.normal_force[0], 2);
  EXPECT_DOUBLE_EQ(std::abs(pulling.tangential_force(0, 1)), 0.5 * 2);  // eq. (5) takes the magnitude
  EXPECT_EQ(repulsive.normal_force[0], 0);
  EXPECT_EQ(repulsive.tangential_force(0, 1), 0);
}

}  // namespace
}  // namespace warpgrain
