#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "core/error.hpp"
#include "core/material.hpp"

namespace warpgrain {
namespace {

const Material soft{"soft", 2500, 1e7, 0.3}, hard{"hard", 4000, 3.8e11, 0.23};

TEST(Material, ModuliOfEqualMaterials) {
  EXPECT_DOUBLE_EQ(effective_youngs_modulus(soft, soft), 1e7 / (2 * (1 - 0.09)));
  EXPECT_DOUBLE_EQ(effective_shear_modulus(soft, soft), 1e7 / (4 * 1.7 * 1.3));
  // The coefficients with which other codes run this material.
  EXPECT_NEAR(4.0 / 3.0 * effective_youngs_modulus(soft, soft), 7.326007326007326e6, 1e-6);
  EXPECT_NEAR(8 * effective_shear_modulus(soft, soft), 9.04977375565611e6, 1e-6);
}

TEST(Material, ModuliAreSymmetricAndGovernedByTheSofter) {
  EXPECT_DOUBLE_EQ(effective_youngs_modulus(soft, hard), effective_youngs_modulus(hard, soft));
  EXPECT_DOUBLE_EQ(effective_shear_modulus(soft, hard), effective_shear_modulus(hard, soft));
  EXPECT_NEAR(effective_youngs_modulus(soft, hard), 1e7 / (1 - 0.09), 1e3);
}

TEST(Material, DampingFollowsFromRestitution) {
  EXPECT_EQ(damping_parameter_of_restitution(1), 0);
  EXPECT_DOUBLE_EQ(damping_parameter_of_restitution(std::exp(-M_PI)), std::sqrt(2.5));
  EXPECT_THROW(damping_parameter_of_restitution(0), InputError);
  EXPECT_THROW(damping_parameter_of_restitution(1.01), InputError);
  EXPECT_THROW(damping_parameter_of_restitution(std::numeric_limits<double>::quiet_NaN()), InputError);
}

}  // namespace
}  // namespace warpgrain
