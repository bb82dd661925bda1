// Approximate functions that are as far off as the PTX ISA allows.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "profiler/approximate_ptx.hpp"
#include "run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

TEST(ApproximatePtx, MarksApproximateFunctionsOfFloatsAlone) {
  const auto marked = [](std::string_view line) { return with_displaced_approximations(line); };
  EXPECT_EQ(marked("sqrt.approx.ftz.f32 %f1, %f2;"), "sqrt.approx.displaced.ftz.f32 %f1, %f2;");
  EXPECT_EQ(marked("rsqrt.approx.f32 %f1, %f2;"), "rsqrt.approx.displaced.f32 %f1, %f2;");
  EXPECT_EQ(marked("div.full.f32 %f1, %f2, %f3;"), "div.full.displaced.f32 %f1, %f2, %f3;");
  for (const char* exact : {"sqrt.rn.f32 %f1, %f2;", "div.rn.f32 %f1, %f2, %f3;", "sin.approx.f32 %f1, %f2;",
                            "rsqrt.approx.f64 %g1, %g2;", "sqrt.rn.f64 %g1, %g2;"})
    EXPECT_EQ(marked(exact), exact);
}

struct Approximation {
  std::string code;  // from %x and %b to %y
  std::function<double(double x, double b)> exact;
  double ulps, relative;  // the PTX ISA's bound: the one that is not zero
  double h100;            // the largest error of an H100 [2^-24]: reports/measured/h100-approximations.json
};

std::string module_of(const std::string& code) {
  return with_displaced_approximations(R"(.version 7.5
.target sm_70
.address_size 64
.entry k(.param .u64 .ptr .global in, .param .u64 .ptr .global out)
{
.reg .b64 %in, %out; .reg .b32 %i; .reg .f32 %x, %b, %y;
ld.param.u64 %in, [in]; ld.param.u64 %out, [out];
mov.u32 %i, %ctaid.x; mad.wide.u32 %in, %i, 8, %in; mad.wide.u32 %out, %i, 4, %out;
ld.global.f32 %x, [%in]; ld.global.f32 %b, [%in+4];
)" + code + "\nst.global.f32 [%out], %y;\nret;\n}\n");
}

std::vector<float> results(const std::string& code, std::vector<std::array<float, 2>> inputs) {
  std::vector<float> out(inputs.size());
  const auto executable = Executable::compile(module_of(code), "k", TraceMode::blocks, "k.ptx");
  run_launch(*executable, line_of(inputs.size(), 1), {buffer_of(inputs), buffer_of(out)});
  return out;
}

const std::vector<Approximation>& approximations() {
  static const std::vector<Approximation> rows{
      {"sqrt.approx.f32 %y, %x;", [](double x, double) { return std::sqrt(x); }, 0, 0x1p-23, 1.678},
      {"rsqrt.approx.f32 %y, %x;", [](double x, double) { return 1 / std::sqrt(x); }, 0, std::exp2(-22.9),
       2.092},
      {"rcp.approx.f32 %y, %x;", [](double x, double) { return 1 / x; }, 1, 0, 1.649},
      {"div.approx.f32 %y, %b, %x;", [](double x, double b) { return b / x; }, 2, 0, 2.578},
      {"div.full.f32 %y, %b, %x;", [](double x, double b) { return b / x; }, 2, 0, 2.578}};
  return rows;
}

// Never beyond the bound, nearly up to it, either way, and the same at every run.
TEST(ApproximatePtx, KeepsTheBoundsAndUsesThem) {
  constexpr unsigned seed = 5;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> exponent(-30, 30);
  std::vector<std::array<float, 2>> inputs(4000);
  for (auto& input : inputs) input = {std::exp2(exponent(random)), std::exp2(exponent(random))};
  for (const Approximation& row : approximations()) {
    const std::vector<float> out = results(row.code, inputs);
    EXPECT_EQ(out, results(row.code, inputs)) << row.code;
    double lowest = 0, highest = 0, largest = 0;
    for (std::size_t k = 0; k < out.size(); ++k) {
      const double exact = row.exact(inputs[k][0], inputs[k][1]);
      const double ulp = std::exp2(std::ilogb(exact) - 23);
      const double share = (out[k] - exact) / (row.relative * exact + row.ulps * ulp);
      largest = std::max(largest, std::abs(out[k] / exact - 1) * 0x1p24);
      lowest = std::min(lowest, share);
      highest = std::max(highest, share);
    }
    EXPECT_GE(lowest, -1) << row.code;
    EXPECT_LE(highest, 1) << row.code;
    EXPECT_LT(lowest, -0.9) << row.code;
    EXPECT_GT(highest, 0.9) << row.code;
    EXPECT_GT(largest, 0.95 * row.h100) << row.code;  // what holds here holds on that device
  }
}

TEST(ApproximatePtx, LeavesZeroInfinityAndNaN) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const auto root = results("sqrt.approx.f32 %y, %x;", {{0, 0}, {infinity, 0}, {-1, 0}});
  EXPECT_EQ(root[0], 0);
  EXPECT_EQ(root[1], infinity);
  EXPECT_TRUE(std::isnan(root[2]));
  const auto quotient = results("div.full.f32 %y, %b, %x;", {{0, 1}, {infinity, 1}, {0, 0}});
  EXPECT_EQ(quotient[0], infinity);
  EXPECT_EQ(quotient[1], 0);
  EXPECT_TRUE(std::isnan(quotient[2]));
}

}  // namespace
}  // namespace warpgrain::profiler
