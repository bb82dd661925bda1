#include <algorithm>
#include <cfenv>

#include "tests/profiler/instruction_bench.hpp"

namespace warpgrain::profiler {
namespace {

using i16 = std::int16_t;
using u16 = std::uint16_t;
using i32 = std::int32_t;
using u32 = std::uint32_t;
using i64 = std::int64_t;
using u64 = std::uint64_t;
__extension__ using i128 = __int128;
__extension__ using u128 = unsigned __int128;

// Two's complement without overflow: through the unsigned type.
template <class T>
T wrap(std::uint64_t value) {
  return static_cast<T>(value);
}

TEST(EmitArithmetic, IntegerSumsAndProducts) {
  InstructionBench bench;
  bench.expect("add.s32 %r3, %r0, %r1;", "%r3", on<u32>([](u32 a, u32 b) { return a + b; }));
  bench.expect("add.u64 %d3, %d0, %d1;", "%d3", on<u64>([](u64 a, u64 b) { return a + b; }));
  bench.expect("add.s16 %h3, %h0, %h1;", "%h3", on<u16>([](u16 a, u16 b) { return wrap<u16>(a + b); }));
  bench.expect("sub.s32 %r3, %r0, %r1;", "%r3", on<u32>([](u32 a, u32 b) { return a - b; }));
  bench.expect("add.sat.s32 %r3, %r0, %r1;", "%r3", on<i32>([](i32 a, i32 b) {
                 return static_cast<i32>(std::clamp<i64>(i64{a} + b, INT32_MIN, INT32_MAX));
               }));
  bench.expect("sub.sat.s32 %r3, %r0, %r1;", "%r3", on<i32>([](i32 a, i32 b) {
                 return static_cast<i32>(std::clamp<i64>(i64{a} - b, INT32_MIN, INT32_MAX));
               }));
  bench.expect("mul.lo.s32 %r3, %r0, %r1;", "%r3", on<u32>([](u32 a, u32 b) { return a * b; }));
  bench.expect("mul.lo.u64 %d3, %d0, %d1;", "%d3", on<u64>([](u64 a, u64 b) { return a * b; }));
  bench.expect("mul.hi.s32 %r3, %r0, %r1;", "%r3",
               on<i32>([](i32 a, i32 b) { return static_cast<i32>((i64{a} * b) >> 32); }));
  bench.expect("mul.hi.u32 %r3, %r0, %r1;", "%r3",
               on<u32>([](u32 a, u32 b) { return static_cast<u32>((u64{a} * b) >> 32); }));
  bench.expect("mul.hi.s64 %d3, %d0, %d1;", "%d3",
               on<i64>([](i64 a, i64 b) { return static_cast<i64>((i128{a} * b) >> 64); }));
  bench.expect("mul.hi.u64 %d3, %d0, %d1;", "%d3",
               on<u64>([](u64 a, u64 b) { return static_cast<u64>((u128{a} * b) >> 64); }));
  bench.expect("mul.wide.s32 %d3, %r0, %r1;", "%d3", on<i32>([](i32 a, i32 b) { return i64{a} * b; }));
  bench.expect("mul.wide.u32 %d3, %r0, %r1;", "%d3", on<u32>([](u32 a, u32 b) { return u64{a} * b; }));
  bench.expect("mul.wide.s16 %r3, %h0, %h1;", "%r3", on<i16>([](i16 a, i16 b) { return i32{a} * b; }));
  bench.expect("mul.wide.u16 %r3, %h0, %h1;", "%r3", on<u16>([](u16 a, u16 b) { return u32{a} * u32{b}; }));
  bench.expect("mad.lo.s32 %r3, %r0, %r1, %r2;", "%r3",
               on<u32>([](u32 a, u32 b, u32 c) { return a * b + c; }));
  bench.expect("mad.hi.u32 %r3, %r0, %r1, %r2;", "%r3",
               on<u32>([](u32 a, u32 b, u32 c) { return static_cast<u32>((u64{a} * b) >> 32) + c; }));
  bench.expect("mad.wide.s32 %d3, %r0, %r1, %d2;", "%d3", [](const BenchInputs& in) {
    return static_cast<u64>(i64{from_bits<i32>(in.a)} * from_bits<i32>(in.b)) + in.c;
  });
  bench.expect("mul24.lo.u32 %r3, %r0, %r1;", "%r3",
               on<u32>([](u32 a, u32 b) { return (a & 0xffffff) * (b & 0xffffff); }));
  bench.expect("mad24.hi.s32 %r3, %r0, %r1, %r2;", "%r3", on<i32>([](i32 a, i32 b, i32 c) {
                 const i64 x = i32(u32(a) << 8) >> 8, y = i32(u32(b) << 8) >> 8;
                 return wrap<i32>(static_cast<u64>((x * y) >> 16) + static_cast<u64>(i64{c}));
               }));
  const auto cut = [](i64 x) { return static_cast<i32>(std::clamp<i64>(x, INT32_MIN, INT32_MAX)); };
  bench.expect("mad.hi.sat.s32 %r3, %r0, %r1, %r2;", "%r3",
               on<i32>([cut](i32 a, i32 b, i32 c) { return cut(((i64{a} * b) >> 32) + c); }));
  bench.expect("mad24.hi.sat.s32 %r3, %r0, %r1, %r2;", "%r3", on<i32>([cut](i32 a, i32 b, i32 c) {
                 const i64 x = i32(u32(a) << 8) >> 8, y = i32(u32(b) << 8) >> 8;
                 return cut(static_cast<i32>((x * y) >> 16) + i64{c});
               }));
  bench.expect("min.relu.s32 %r3, %r0, %r1;", "%r3",
               on<i32>([](i32 a, i32 b) { return std::max(std::min(a, b), 0); }));
  bench.expect("max.relu.s32 %r3, %r0, %r1;", "%r3",
               on<i32>([](i32 a, i32 b) { return std::max(std::max(a, b), 0); }));
  bench.expect("sad.s32 %r3, %r0, %r1, %r2;", "%r3", on<i32>([](i32 a, i32 b, i32 c) {
                 return wrap<i32>(static_cast<u64>(std::abs(i64{a} - b)) + static_cast<u64>(i64{c}));
               }));
  bench.expect("sad.u32 %r3, %r0, %r1, %r2;", "%r3",
               on<u32>([](u32 a, u32 b, u32 c) { return (a < b ? b - a : a - b) + c; }));
  bench.run(integer_inputs());
}

TEST(EmitArithmetic, QuotientsAndRemaindersOfEveryDivisor) {
  InstructionBench bench;
  bench.expect("div.u32 %r3, %r0, %r1;", "%r3", on<u32>([](u32 a, u32 b) { return b == 0 ? ~0u : a / b; }));
  bench.expect("rem.u32 %r3, %r0, %r1;", "%r3", on<u32>([](u32 a, u32 b) { return b == 0 ? a : a % b; }));
  bench.expect("div.u64 %d3, %d0, %d1;", "%d3",
               on<u64>([](u64 a, u64 b) { return b == 0 ? ~u64{0} : a / b; }));
  bench.expect("div.s32 %r3, %r0, %r1;", "%r3",
               on<i32>([](i32 a, i32 b) { return b == 0 ? -1 : static_cast<i32>(i64{a} / b); }));
  bench.expect("rem.s32 %r3, %r0, %r1;", "%r3",
               on<i32>([](i32 a, i32 b) { return b == 0 ? a : static_cast<i32>(i64{a} % b); }));
  bench.expect("div.s64 %d3, %d0, %d1;", "%d3",
               on<i64>([](i64 a, i64 b) { return b == 0 ? i64{-1} : static_cast<i64>(i128{a} / b); }));
  bench.expect("rem.s16 %h3, %h0, %h1;", "%h3",
               on<i16>([](i16 a, i16 b) { return b == 0 ? a : static_cast<i16>(a % b); }));
  bench.run(integer_inputs());
}

TEST(EmitArithmetic, SignsAndExtrema) {
  InstructionBench bench;
  bench.expect("abs.s32 %r3, %r0;", "%r3",
               on<i32>([](i32 a) { return a < 0 ? wrap<i32>(0u - static_cast<u32>(a)) : a; }));
  bench.expect("neg.s64 %d3, %d0;", "%d3", on<u64>([](u64 a) { return 0 - a; }));
  bench.expect("min.s32 %r3, %r0, %r1;", "%r3", on<i32>([](i32 a, i32 b) { return std::min(a, b); }));
  bench.expect("min.u32 %r3, %r0, %r1;", "%r3", on<u32>([](u32 a, u32 b) { return std::min(a, b); }));
  bench.expect("max.s16 %h3, %h0, %h1;", "%h3", on<i16>([](i16 a, i16 b) { return std::max(a, b); }));
  bench.expect("max.u64 %d3, %d0, %d1;", "%d3", on<u64>([](u64 a, u64 b) { return std::max(a, b); }));
  bench.run(integer_inputs());
}

TEST(EmitArithmetic, CarriesGoFromWordToWord) {
  InstructionBench bench;
  // 64-bit sums, differences and products from 32-bit words
  const std::string split = "{mov.b64 {%r3, %r4}, %d0; mov.b64 {%r5, %r6}, %d1; ";
  bench.expect(split + "add.cc.u32 %r3, %r3, %r5; addc.u32 %r4, %r4, %r6; mov.b64 %d3, {%r3, %r4};}", "%d3",
               on<u64>([](u64 a, u64 b) { return a + b; }));
  bench.expect(split + "sub.cc.u32 %r3, %r3, %r5; subc.u32 %r4, %r4, %r6; mov.b64 %d3, {%r3, %r4};}", "%d3",
               on<u64>([](u64 a, u64 b) { return a - b; }));
  bench.expect("mad.lo.cc.u32 %r3, %r0, %r1, %r2; madc.hi.u32 %r4, %r0, %r1, 0; mov.b64 %d3, {%r3, %r4};",
               "%d3", on<u32>([](u32 a, u32 b, u32 c) { return u64{a} * b + c; }));
  bench.expect("add.cc.u64 %d3, %d0, %d1; addc.u64 %d4, 0, 0;", "%d4",
               on<u64>([](u64 a, u64 b) { return u64{a + b < a}; }));
  bench.expect("add.cc.u32 %r3, %r0, %r1; addc.cc.u32 %r4, %r0, %r2; addc.u32 %r5, 0, 0;", "%r5",
               on<u32>([](u32 a, u32 b, u32 c) {
                 return static_cast<u32>((u64{a} + c + ((u64{a} + b) >> 32)) >> 32);
               }));
  bench.run(integer_inputs());
}

template <class T>
T least(T a, T b) {
  if (std::isnan(a)) return b;
  if (std::isnan(b)) return a;
  if (a == b) return std::signbit(a) ? a : b;
  return a < b ? a : b;
}

template <class T>
T greatest(T a, T b) {
  if (std::isnan(a)) return b;
  if (std::isnan(b)) return a;
  if (a == b) return std::signbit(a) ? b : a;
  return a > b ? a : b;
}

TEST(EmitArithmetic, Floats) {
  InstructionBench bench;
  bench.expect("add.rn.f32 %f3, %f0, %f1;", "%f3", on<float>([](float a, float b) { return a + b; }));
  bench.expect("sub.f32 %f3, %f0, %f1;", "%f3", on<float>([](float a, float b) { return a - b; }));
  bench.expect("mul.f32 %f3, %f0, %f1;", "%f3", on<float>([](float a, float b) { return a * b; }));
  // Fused only where it says so.
  bench.expect("fma.rn.f32 %f3, %f0, %f1, %f2;", "%f3",
               on<float>([](float a, float b, float c) { return std::fma(a, b, c); }));
  bench.expect("mad.f32 %f3, %f0, %f1, %f2;", "%f3",
               on<float>([](float a, float b, float c) { return std::fma(a, b, c); }));
  bench.expect("mul.f32 %f3, %f0, %f1; add.f32 %f3, %f3, %f2;", "%f3",
               on<float>([](float a, float b, float c) {
                 volatile float product = a * b;
                 return product + c;
               }));
  for (const char* kind : {"full", "approx", "rn"})
    bench.expect(fmt::format("div.{}.f32 %f3, %f0, %f1;", kind), "%f3",
                 on<float>([](float a, float b) { return a / b; }));
  bench.expect("abs.f32 %f3, %f0;", "%f3", on<float>([](float a) { return std::fabs(a); }));
  bench.expect("neg.f32 %f3, %f0;", "%f3", on<float>([](float a) { return -a; }));
  bench.expect("min.f32 %f3, %f0, %f1;", "%f3", on<float>(least<float>));
  bench.expect("max.f32 %f3, %f0, %f1;", "%f3", on<float>(greatest<float>));
  bench.expect("min.NaN.f32 %f3, %f0, %f1;", "%f3", on<float>([](float a, float b) {
                 return std::isnan(a) ? a : std::isnan(b) ? b : least(a, b);
               }));
  bench.expect("add.sat.f32 %f3, %f0, %f1;", "%f3", on<float>([](float a, float b) {
                 const float sum = a + b;
                 return !(sum > 0) ? 0.0f : sum < 1 ? sum : 1.0f;
               }));
  const auto flush = [](float x) { return std::fpclassify(x) == FP_SUBNORMAL ? std::copysign(0.0f, x) : x; };
  bench.expect("add.ftz.f32 %f3, %f0, %f1;", "%f3",
               on<float>([flush](float a, float b) { return flush(flush(a) + flush(b)); }));
  bench.expect("mul.ftz.f32 %f3, %f0, %f1;", "%f3",
               on<float>([flush](float a, float b) { return flush(flush(a) * flush(b)); }));
  bench.run(float_inputs());
}

// f in a rounding mode; the volatile keeps it there.
template <class T, class F>
Reference rounded(int mode, F f) {
  return on<T>([mode, f](T a, T b, T c) {
    volatile T x = a, y = b, z = c;
    std::fesetround(mode);
    volatile T result = f(x, y, z);
    std::fesetround(FE_TONEAREST);
    return T{result};
  });
}

TEST(EmitArithmetic, DirectedRoundings) {
  InstructionBench floats, doubles;
  for (const auto& [name, mode] : {std::pair{"rz", FE_TOWARDZERO}, {"rm", FE_DOWNWARD}, {"rp", FE_UPWARD}}) {
    const auto add = [&](const char* code, auto f) {
      floats.expect(fmt::format("{}.f32 %f3, {};", fmt::format(fmt::runtime(code), name), "%f0, %f1"), "%f3",
                    rounded<float>(mode, f));
      doubles.expect(fmt::format("{}.f64 %g3, {};", fmt::format(fmt::runtime(code), name), "%g0, %g1"), "%g3",
                     rounded<double>(mode, f));
    };
    add("add.{}", [](auto& a, auto& b, auto&) { return a + b; });
    add("sub.{}", [](auto& a, auto& b, auto&) { return a - b; });
    add("mul.{}", [](auto& a, auto& b, auto&) { return a * b; });
    add("div.{}", [](auto& a, auto& b, auto&) { return a / b; });
    floats.expect(fmt::format("fma.{}.f32 %f3, %f0, %f1, %f2;", name), "%f3",
                  rounded<float>(mode, [](auto& a, auto& b, auto& c) { return std::fma(a, b, c); }));
    floats.expect(fmt::format("sqrt.{}.f32 %f3, %f0;", name), "%f3",
                  rounded<float>(mode, [](auto& a, auto&, auto&) { return std::sqrt(a); }));
    doubles.expect(fmt::format("rcp.{}.f64 %g3, %g0;", name), "%g3",
                   rounded<double>(mode, [](auto& a, auto&, auto&) { return 1.0 / a; }));
    doubles.expect(fmt::format("cvt.{}.f32.f64 %f3, %g0; cvt.f64.f32 %g3, %f3;", name), "%g3",
                   rounded<double>(mode, [](auto& a, auto&, auto&) { return static_cast<float>(a); }));
  }
  floats.run(float_inputs());
  doubles.run(double_inputs());
}

TEST(EmitArithmetic, Doubles) {
  InstructionBench bench;
  bench.expect("add.rn.f64 %g3, %g0, %g1;", "%g3", on<double>([](double a, double b) { return a + b; }));
  bench.expect("mul.rn.f64 %g3, %g0, %g1;", "%g3", on<double>([](double a, double b) { return a * b; }));
  bench.expect("div.rn.f64 %g3, %g0, %g1;", "%g3", on<double>([](double a, double b) { return a / b; }));
  bench.expect("fma.rn.f64 %g3, %g0, %g1, %g2;", "%g3",
               on<double>([](double a, double b, double c) { return std::fma(a, b, c); }));
  bench.expect("max.f64 %g3, %g0, %g1;", "%g3", on<double>(greatest<double>));
  bench.expect("add.f64 %g3, %g0, 0d3FF8000000000000;", "%g3", on<double>([](double a) { return a + 1.5; }));
  bench.run(double_inputs());
}

}  // namespace
}  // namespace warpgrain::profiler
