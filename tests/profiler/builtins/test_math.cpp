// Every function of real numbers within OpenCL's limits.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/profiler/builtins/measurement.hpp"
#include "tests/profiler/builtins/random.hpp"

namespace warpgrain::profiler::builtins {
namespace {

void expect_within_limits(const std::vector<Measurement>& measured) {
  for (const Measurement& m : measured) {
    EXPECT_GT(m.samples, 100U) << m.function;
    EXPECT_LE(m.worst, m.limit) << fmt::format("{}, seed {}, error {}: {}", m.function, seed, m.worst,
                                               m.worst_case);
  }
}

TEST(MathFunctions, ElementaryFloat) { expect_within_limits(measure<float>(elementary_functions())); }
TEST(MathFunctions, ElementaryDouble) { expect_within_limits(measure<double>(elementary_functions())); }
TEST(MathFunctions, OtherFloat) { expect_within_limits(measure<float>(other_math_functions())); }
TEST(MathFunctions, OtherDouble) { expect_within_limits(measure<double>(other_math_functions())); }
TEST(MathFunctions, CommonFloat) { expect_within_limits(measure<float>(common_functions())); }
TEST(MathFunctions, CommonDouble) { expect_within_limits(measure<double>(common_functions())); }
TEST(MathFunctions, Approximate) { expect_within_limits(measure<float>(approximate_functions())); }

}  // namespace
}  // namespace warpgrain::profiler::builtins
