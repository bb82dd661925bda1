#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>

#include "analysis/force_error.hpp"
#include "core/error.hpp"

namespace warpgrain {
namespace {

ParticleState three_particles() {
  ParticleState state;
  state.id = {4, 7, 9};
  return state;
}

ForceState reference() { return {{{0, 0, 3}, {0, 4, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}; }

TEST(ForceError, IsRelativeToTheLargestReferenceForce) {
  ForceState measured = reference();
  measured.force[2] = {0.2, 0, 0};
  measured.force[0] = {0, 0.1, 3};
  const ForceError error = force_error(three_particles(), measured, reference());
  EXPECT_DOUBLE_EQ(error.force.scale, 4.0);
  EXPECT_DOUBLE_EQ(error.force.maximum, 0.05);
  EXPECT_EQ(error.force.worst_particle, 9u);
  EXPECT_DOUBLE_EQ(error.force.root_mean_square, std::sqrt((0.04 + 0.01) / 3) / 4);
  EXPECT_EQ(error.torque.maximum, 0.0) << "zero against zero";
}

TEST(ForceError, NamesTheParticleThatIsNotFinite) {
  ForceState measured = reference();
  measured.torque[1].x() = std::numeric_limits<double>::quiet_NaN();
  try {
    force_error(three_particles(), measured, reference());
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("torque on particle 7"));
  }
}

TEST(ForceError, RefusesOtherSizesAndAZeroScale) {
  ForceState measured = reference();
  measured.torque[0].x() = 1;
  EXPECT_THROW(force_error(three_particles(), measured, reference()), InputError)
      << "no torque to compare with";
  measured = reference();
  measured.force.pop_back();
  EXPECT_THROW(force_error(three_particles(), measured, reference()), InputError);
}

}  // namespace
}  // namespace warpgrain
