#include <algorithm>

#include "tests/profiler/instruction_bench.hpp"

namespace warpgrain::profiler {
namespace {

using i8 = std::int8_t;
using u8 = std::uint8_t;
using i16 = std::int16_t;
using u16 = std::uint16_t;
using i32 = std::int32_t;
using u32 = std::uint32_t;
using i64 = std::int64_t;
using u64 = std::uint64_t;

TEST(EmitConvert, Integers) {
  InstructionBench bench;
  bench.expect("cvt.s64.s32 %d3, %r0;", "%d3", on<i32>([](i32 a) { return i64{a}; }));
  bench.expect("cvt.u64.u32 %d3, %r0;", "%d3", on<u32>([](u32 a) { return u64{a}; }));
  bench.expect("cvt.u32.u64 %r3, %d0;", "%r3", on<u64>([](u64 a) { return static_cast<u32>(a); }));
  bench.expect("cvt.s32.s8 %r3, %r0;", "%r3", on<i8>([](i8 a) { return i32{a}; }));
  bench.expect("cvt.u32.u8 %r3, %h0;", "%r3", on<u8>([](u8 a) { return u32{a}; }));
  bench.expect("cvt.u16.u8 %h3, %h0;", "%h3", on<u8>([](u8 a) { return u16{a}; }));
  bench.expect("cvt.s16.s32 %h3, %r0;", "%h3", on<u32>([](u32 a) { return static_cast<u16>(a); }));
  bench.expect("cvt.s8.s32 %r3, %r0;", "%r3", on<i8>([](i8 a) { return i32{a}; }));
  bench.expect("cvt.sat.u8.s32 %r3, %r0;", "%r3", on<i32>([](i32 a) { return std::clamp(a, 0, 255); }));
  bench.expect("cvt.sat.s16.s64 %r3, %d0;", "%r3",
               on<i64>([](i64 a) { return static_cast<i32>(std::clamp<i64>(a, INT16_MIN, INT16_MAX)); }));
  bench.expect("cvt.sat.u32.s32 %r3, %r0;", "%r3", on<i32>([](i32 a) { return std::max(a, 0); }));
  bench.expect("cvt.sat.s32.u32 %r3, %r0;", "%r3",
               on<u32>([](u32 a) { return std::min<u32>(a, INT32_MAX); }));
  bench.expect("cvt.sat.s64.u64 %d3, %d0;", "%d3",
               on<u64>([](u64 a) { return std::min<u64>(a, INT64_MAX); }));
  bench.run(integer_inputs());
}

TEST(EmitConvert, IntegersToFloats) {
  InstructionBench bench;
  bench.expect("cvt.rn.f32.s32 %f3, %r0;", "%f3", on<i32>([](i32 a) { return static_cast<float>(a); }));
  bench.expect("cvt.rn.f32.u32 %f3, %r0;", "%f3", on<u32>([](u32 a) { return static_cast<float>(a); }));
  bench.expect("cvt.rn.f32.u64 %f3, %d0;", "%f3", on<u64>([](u64 a) { return static_cast<float>(a); }));
  bench.expect("cvt.rn.f32.s16 %f3, %h0;", "%f3", on<i16>([](i16 a) { return static_cast<float>(a); }));
  bench.expect("cvt.rn.f32.u8 %f3, %h0;", "%f3", on<u8>([](u8 a) { return static_cast<float>(a); }));
  bench.expect("cvt.rn.f64.s64 %g3, %d0;", "%g3", on<i64>([](i64 a) { return static_cast<double>(a); }));
  bench.expect("cvt.rz.f32.s32 %f3, %r0;", "%f3", on<i32>([](i32 a) {
                 const float nearest = static_cast<float>(a);
                 return std::fabs(static_cast<double>(nearest)) > std::fabs(static_cast<double>(a))
                            ? std::nextafter(nearest, 0.0f)
                            : nearest;
               }));
  bench.expect("cvt.rp.f64.u64 %g3, %d0;", "%g3", on<u64>([](u64 a) {
                 const double nearest = static_cast<double>(a);
                 return static_cast<long double>(nearest) < static_cast<long double>(a)
                            ? std::nextafter(nearest, 1e300)
                            : nearest;
               }));
  bench.expect("cvt.rn.f64.u32 %g3, %r0;", "%g3", on<u32>([](u32 a) { return static_cast<double>(a); }));
  bench.run(integer_inputs());
}

// Rounded as asked, cut to the type's range, NaN to 0.
template <class T, class From, class Round>
T to_integer(From x, Round round) {
  if (std::isnan(x)) return 0;
  const From integral = round(x);
  if (integral <= static_cast<From>(std::numeric_limits<T>::min())) return std::numeric_limits<T>::min();
  if (integral >= static_cast<From>(std::numeric_limits<T>::max())) return std::numeric_limits<T>::max();
  return static_cast<T>(integral);
}

TEST(EmitConvert, FloatsToIntegers) {
  InstructionBench bench;
  const auto nearest = [](float x) { return std::nearbyint(x); };
  const auto towards_zero = [](float x) { return std::trunc(x); };
  const auto down = [](float x) { return std::floor(x); };
  const auto up = [](float x) { return std::ceil(x); };
  bench.expect("cvt.rni.s32.f32 %r3, %f0;", "%r3",
               on<float>([=](float x) { return to_integer<i32>(x, nearest); }));
  bench.expect("cvt.rzi.s32.f32 %r3, %f0;", "%r3",
               on<float>([=](float x) { return to_integer<i32>(x, towards_zero); }));
  bench.expect("cvt.rmi.s32.f32 %r3, %f0;", "%r3",
               on<float>([=](float x) { return to_integer<i32>(x, down); }));
  bench.expect("cvt.rpi.u32.f32 %r3, %f0;", "%r3",
               on<float>([=](float x) { return to_integer<u32>(x, up); }));
  bench.expect("cvt.rzi.u64.f32 %d3, %f0;", "%d3",
               on<float>([=](float x) { return to_integer<u64>(x, towards_zero); }));
  bench.expect("cvt.rzi.s64.f32 %d3, %f0;", "%d3",
               on<float>([=](float x) { return to_integer<i64>(x, towards_zero); }));
  bench.expect("cvt.rzi.u8.f32 %r3, %f0;", "%r3",
               on<float>([=](float x) { return to_integer<u8>(x, towards_zero); }));
  bench.expect("cvt.rzi.s16.f32 %r3, %f0;", "%r3",
               on<float>([=](float x) { return i32{to_integer<i16>(x, towards_zero)}; }));
  bench.run(float_inputs());
}

TEST(EmitConvert, Floats) {
  InstructionBench bench;
  bench.expect("cvt.f64.f32 %g3, %f0;", "%g3", on<float>([](float x) { return static_cast<double>(x); }));
  bench.expect("cvt.rni.f32.f32 %f3, %f0;", "%f3", on<float>([](float x) { return std::nearbyint(x); }));
  bench.expect("cvt.rzi.f32.f32 %f3, %f0;", "%f3", on<float>([](float x) { return std::trunc(x); }));
  bench.expect("cvt.rmi.f32.f32 %f3, %f0;", "%f3", on<float>([](float x) { return std::floor(x); }));
  bench.expect("cvt.rpi.f32.f32 %f3, %f0;", "%f3", on<float>([](float x) { return std::ceil(x); }));
  bench.expect("cvt.sat.f32.f32 %f3, %f0;", "%f3",
               on<float>([](float x) { return !(x > 0) ? 0.0f : std::min(x, 1.0f); }));
  bench.expect("cvt.ftz.f32.f32 %f3, %f0;", "%f3", on<float>([](float x) {
                 return std::fpclassify(x) == FP_SUBNORMAL ? std::copysign(0.0f, x) : x;
               }));
  // Half precision there and back: 11 bits of mantissa.
  bench.expect("cvt.rn.f16.f32 %h3, %f0; cvt.f32.f16 %f3, %h3;", "%f3", on<float>([](float x) {
                 if (std::isnan(x) || std::isinf(x) || x == 0) return x;
                 const int exponent = std::max(std::ilogb(x), -14);
                 const float unit = std::ldexp(1.0f, exponent - 10);
                 const float rounded = std::nearbyint(x / unit) * unit;
                 return std::fabs(rounded) > 65504.0f
                            ? std::copysign(std::numeric_limits<float>::infinity(), x)
                        : rounded == 0 ? std::copysign(0.0f, x)
                                       : rounded;
               }));
  bench.run(float_inputs());
  InstructionBench doubles;
  doubles.expect("cvt.rn.f32.f64 %f3, %g0;", "%f3",
                 on<double>([](double x) { return static_cast<float>(x); }));
  doubles.expect("cvt.rzi.s64.f64 %d3, %g0;", "%d3", on<double>([](double x) {
                   return to_integer<i64>(x, [](double y) { return std::trunc(y); });
                 }));
  doubles.expect("cvt.rpi.f64.f64 %g3, %g0;", "%g3", on<double>([](double x) { return std::ceil(x); }));
  doubles.run(double_inputs());
}

TEST(EmitConvert, IntegersToFloatsBetweenZeroAndOne) {
  InstructionBench bench;
  bench.expect("cvt.rn.sat.f32.s32 %f3, %r0;", "%f3", on<i32>([](i32 a) { return a <= 0 ? 0.0f : 1.0f; }));
  bench.run(integer_inputs());
}

TEST(EmitConvert, ToFloatsInOneDirectionWithFlushingAndSaturation) {
  InstructionBench bench;
  const auto towards_zero = [](double x) {
    const float nearest = static_cast<float>(x);
    return std::fabs(static_cast<double>(nearest)) > std::fabs(x) ? std::nextafter(nearest, 0.0f) : nearest;
  };
  bench.expect("cvt.rz.ftz.f32.f64 %f3, %g0;", "%f3", on<double>([=](double x) {
                 const float cut = towards_zero(x);
                 return std::fpclassify(cut) == FP_SUBNORMAL ? std::copysign(0.0f, cut) : cut;
               }));
  bench.expect("cvt.rz.sat.f32.f64 %f3, %g0;", "%f3",
               on<double>([=](double x) { return !(x > 0) ? 0.0f : std::min(towards_zero(x), 1.0f); }));
  bench.run(double_inputs());
}

// The neighbours among halves: what a direction gives lies on its side, and within one unit.
TEST(EmitConvert, ToHalvesInOneDirection) {
  std::vector<BenchInputs> inputs = float_inputs();
  for (const float x : {65504.0f, 65505.0f, 65519.0f, 65520.0f, 2049.5f, 6.1e-5f, 5.9e-8f, 1e-9f, 0.1f})
    for (const float sign : {1.0f, -1.0f}) inputs.push_back({to_bits(sign * x), 0, 0});
  const auto unit_at = [](float x) { return std::ldexp(1.0f, std::max(std::ilogb(x), -14) - 10); };
  const auto directed = [unit_at](float x, int direction) {  // -1 down, 1 up
    if (!std::isfinite(x) || x == 0) return x;
    const float units = x / unit_at(x);
    const float result = (direction < 0 ? std::floor(units) : std::ceil(units)) * unit_at(x);
    if (std::fabs(result) <= 65504.0f) return result == 0 ? std::copysign(0.0f, x) : result;
    const bool outwards = (direction < 0) == std::signbit(x);
    return std::copysign(outwards ? std::numeric_limits<float>::infinity() : 65504.0f, x);
  };
  InstructionBench bench;
  const auto add = [&](const std::string& rounding, auto direction) {
    bench.expect(fmt::format("cvt.{}.f16.f32 %h3, %f0; cvt.f32.f16 %f3, %h3;", rounding), "%f3",
                 on<float>([=](float x) { return directed(x, direction(x)); }));
  };
  add("rm", [](float) { return -1; });
  add("rp", [](float) { return 1; });
  add("rz", [](float x) { return std::signbit(x) ? 1 : -1; });
  bench.run(inputs);
}

TEST(EmitConvert, PacksSaturatedValues) {
  InstructionBench bench;
  bench.expect("cvt.pack.sat.s16.s32 %r3, %r0, %r1;", "%r3", on<i32>([](i32 a, i32 b) {
                 const auto cut = [](i32 x) { return static_cast<u16>(std::clamp(x, -32768, 32767)); };
                 return u32{cut(a)} << 16 | cut(b);
               }));
  bench.expect("cvt.pack.sat.u8.s32.b32 %r3, %r0, %r1, %r2;", "%r3", on<i32>([](i32 a, i32 b, i32 c) {
                 const auto cut = [](i32 x) { return static_cast<u32>(std::clamp(x, 0, 255)); };
                 return static_cast<u32>(c) << 16 | cut(a) << 8 | cut(b);
               }));
  bench.run(integer_inputs());
}

}  // namespace
}  // namespace warpgrain::profiler
