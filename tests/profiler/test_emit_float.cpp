#include "tests/profiler/instruction_bench.hpp"

namespace warpgrain::profiler {
namespace {

template <class F>
Reference rounded_from_double(F function) {
  return on<float>([function](float x) { return static_cast<float>(function(static_cast<double>(x))); });
}

TEST(EmitFloat, FunctionsAreRoundedOnce) {
  InstructionBench bench;
  for (const char* kind : {"approx", "rn"}) {
    bench.expect(fmt::format("sqrt.{}.f32 %f3, %f0;", kind), "%f3",
                 on<float>([](float x) { return std::sqrt(x); }));
    bench.expect(fmt::format("rcp.{}.f32 %f3, %f0;", kind), "%f3",
                 on<float>([](float x) { return 1.0f / x; }));
  }
  bench.expect("rsqrt.approx.f32 %f3, %f0;", "%f3",
               rounded_from_double([](double x) { return 1.0 / std::sqrt(x); }));
  bench.expect("sin.approx.f32 %f3, %f0;", "%f3", rounded_from_double([](double x) { return std::sin(x); }));
  bench.expect("cos.approx.f32 %f3, %f0;", "%f3", rounded_from_double([](double x) { return std::cos(x); }));
  bench.expect("ex2.approx.f32 %f3, %f0;", "%f3", rounded_from_double([](double x) { return std::exp2(x); }));
  bench.expect("lg2.approx.f32 %f3, %f0;", "%f3", rounded_from_double([](double x) { return std::log2(x); }));
  bench.expect("tanh.approx.f32 %f3, %f0;", "%f3",
               rounded_from_double([](double x) { return std::tanh(x); }));
  bench.expect("sqrt.approx.ftz.f32 %f3, %f0;", "%f3", on<float>([](float x) {
                 return std::fpclassify(x) == FP_SUBNORMAL ? std::copysign(0.0f, x) : std::sqrt(x);
               }));
  bench.expect("copysign.f32 %f3, %f0, %f1;", "%f3",
               on<float>([](float sign, float x) { return std::copysign(x, sign); }));
  bench.run(float_inputs());
}

TEST(EmitFloat, Doubles) {
  InstructionBench bench;
  bench.expect("sqrt.rn.f64 %g3, %g0;", "%g3", on<double>([](double x) { return std::sqrt(x); }));
  bench.expect("rcp.rn.f64 %g3, %g0;", "%g3", on<double>([](double x) { return 1.0 / x; }));
  bench.expect("rsqrt.approx.f64 %g3, %g0;", "%g3", on<double>([](double x) { return 1.0 / std::sqrt(x); }));
  bench.run(double_inputs());
}

// .approx.ftz of f64 sees and gives the upper words alone.
TEST(EmitFloat, RoughReciprocalsOfDoubles) {
  const auto upper = [](double x) {
    const auto cut = from_bits<double>(to_bits(x) & ~std::uint64_t{0xffffffff});
    return std::fpclassify(cut) == FP_SUBNORMAL ? std::copysign(0.0, cut) : cut;
  };
  InstructionBench bench;
  bench.expect("rcp.approx.ftz.f64 %g3, %g0;", "%g3",
               on<double>([=](double x) { return upper(1.0 / upper(x)); }));
  bench.expect("rsqrt.approx.ftz.f64 %g3, %g0;", "%g3",
               on<double>([=](double x) { return upper(1.0 / std::sqrt(upper(x))); }));
  bench.run(double_inputs());
}

TEST(EmitFloat, ExtremaOfMagnitudesWithTheProductsSign) {
  InstructionBench bench;
  const auto signed_as = [](float value, float a, float b) {
    return std::copysign(value, std::signbit(a) == std::signbit(b) ? 1.0f : -1.0f);
  };
  bench.expect("min.xorsign.abs.f32 %f3, %f0, %f1;", "%f3", on<float>([=](float a, float b) {
                 return signed_as(std::fmin(std::fabs(a), std::fabs(b)), a, b);
               }));
  bench.expect("max.xorsign.abs.f32 %f3, %f0, %f1;", "%f3", on<float>([=](float a, float b) {
                 return signed_as(std::fmax(std::fabs(a), std::fabs(b)), a, b);
               }));
  bench.run(float_inputs());
}

TEST(EmitFloat, Classes) {
  InstructionBench bench;
  const auto add = [&bench](const char* name, auto test) {
    bench.expect(fmt::format("testp.{}.f32 %p3, %f0;", name), "%p3",
                 on<float>([test](float x) { return test(x); }));
  };
  add("finite", [](float x) { return std::isfinite(x); });
  add("infinite", [](float x) { return std::isinf(x); });
  add("number", [](float x) { return !std::isnan(x); });
  add("notanumber", [](float x) { return std::isnan(x); });
  add("normal", [](float x) { return std::isnormal(x); });
  add("subnormal", [](float x) { return std::fpclassify(x) == FP_SUBNORMAL; });
  bench.run(float_inputs());
}

}  // namespace
}  // namespace warpgrain::profiler
