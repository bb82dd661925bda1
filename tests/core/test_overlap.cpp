#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "core/overlap.hpp"

namespace warpgrain {
namespace {

// Floats in, the overlap of exactly these floats out: the reference is long double.
TEST(Overlap, IsExactInFloatWhereNearlyAllDigitsCancel) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> component(-1, 1);
  for (int k = 0; k < 10000; ++k) {
    Vector3<float> apart(component(random), component(random), component(random));
    const float reach = 0.002F, relative_overlap = std::exp2(-4 - 16 * std::abs(component(random)));
    apart *= reach * (1 - relative_overlap) / apart.norm();
    const auto square = [](long double x) { return x * x; };
    const long double overlap = static_cast<long double>(reach) -
                                std::sqrt(square(apart.x()) + square(apart.y()) + square(apart.z()));
    const float computed = overlap_of_spheres(apart, apart.norm(), reach);
    // The result's own rounding, and what a Newton step leaves.
    EXPECT_NEAR(computed, static_cast<double>(overlap), 1.5e-7 * static_cast<double>(overlap))
        << "sample " << k;
  }
}

TEST(Overlap, IsThePlainDifferenceInDouble) { EXPECT_EQ(overlap_of_spheres<double>({3, 4, 0}, 5, 5.5), 0.5); }

}  // namespace
}  // namespace warpgrain
