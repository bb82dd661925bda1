#include <cmath>
#include <gtest/gtest.h>

#include "analysis/impact_theory.hpp"

namespace warpgrain {
namespace {

// Chung & Ooi's test 1: spheres of glass, radius 10 mm, +-10 m/s. Energy is what the closed form is made of.
TEST(ImpactTheory, HertzImpactStoresTheKineticEnergy) {
  const double density = 2800, radius = 0.01, mass = 4.0 / 3 * M_PI * std::pow(radius, 3) * density;
  const double modulus = 4.8e10 / (2 * (1 - 0.2 * 0.2)), speed = 20;
  const HertzImpact impact = hertz_impact(4.0 / 3 * modulus, radius / 2, mass / 2, speed);
  EXPECT_NEAR(0.4 * impact.largest_force * impact.largest_overlap, mass / 4 * speed * speed, 1e-9);
  EXPECT_NEAR(impact.duration * speed, 2.9432 * impact.largest_overlap, 1e-12);
  EXPECT_NEAR(hertz_overlap(4.0 / 3 * modulus, radius / 2, impact.largest_force), impact.largest_overlap,
              1e-12);
}

// Its impulse turns the velocity around; it is largest in the middle.
TEST(ImpactTheory, HertzForceGivesTheImpulse) {
  const HertzImpact impact = hertz_impact(1e7, 0.005, 0.02, 3);
  double impulse = 0;
  constexpr int parts = 400;
  for (int k = 0; k < parts; ++k)
    impulse += hertz_force(impact, impact.duration * (k + 0.5) / parts) * impact.duration / parts;
  EXPECT_NEAR(impulse, 2 * 0.02 * 3, 1e-5);
  EXPECT_NEAR(hertz_force(impact, impact.duration / 2), impact.largest_force, 1e-6 * impact.largest_force);
  EXPECT_EQ(hertz_force(impact, 2 * impact.duration), 0);
}

TEST(ImpactTheory, SlidingTakesMuTimesTheNormalImpulse) {
  const SlidingImpact flat = sliding_impact(1, 10, 0.01, 1, 0.1);
  EXPECT_TRUE(flat.slips_throughout);
  EXPECT_DOUBLE_EQ(flat.tangential_velocity, 9.8);
  EXPECT_DOUBLE_EQ(flat.angular_velocity, 50);
  EXPECT_FALSE(sliding_impact(1, 0.5, 0.01, 1, 0.1).slips_throughout);
}

TEST(ImpactTheory, LinearRestitutionRunsFromOneToNothing) {
  EXPECT_EQ(linear_restitution(100, 0, 1), 1);
  EXPECT_EQ(linear_restitution(100, 20, 1), 0);
  EXPECT_NEAR(linear_restitution(100, 10, 1), std::exp(-M_PI * 0.5 / std::sqrt(0.75)), 1e-15);
}

}  // namespace
}  // namespace warpgrain
