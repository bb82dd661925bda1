#include "tests/profiler/instruction_bench.hpp"

namespace warpgrain::profiler {
namespace {

using i32 = std::int32_t;
using u32 = std::uint32_t;
using i64 = std::int64_t;
using u64 = std::uint64_t;

TEST(EmitCompare, Integers) {
  InstructionBench bench;
  const auto add = [&bench](const char* name, auto compare) {
    bench.expect(fmt::format("setp.{}.s32 %p3, %r0, %r1;", name), "%p3",
                 on<i32>([compare](i32 a, i32 b) { return compare(a, b); }));
    bench.expect(fmt::format("setp.{}.u32 %p3, %r0, %r1;", name), "%p3",
                 on<u32>([compare](u32 a, u32 b) { return compare(a, b); }));
    bench.expect(fmt::format("setp.{}.s64 %p3, %d0, %d1;", name), "%p3",
                 on<i64>([compare](i64 a, i64 b) { return compare(a, b); }));
  };
  add("eq", [](auto a, auto b) { return a == b; });
  add("ne", [](auto a, auto b) { return a != b; });
  add("lt", [](auto a, auto b) { return a < b; });
  add("le", [](auto a, auto b) { return a <= b; });
  add("gt", [](auto a, auto b) { return a > b; });
  add("ge", [](auto a, auto b) { return a >= b; });
  bench.expect("setp.lo.u32 %p3, %r0, %r1;", "%p3", on<u32>([](u32 a, u32 b) { return a < b; }));
  bench.expect("setp.ls.u32 %p3, %r0, %r1;", "%p3", on<u32>([](u32 a, u32 b) { return a <= b; }));
  bench.expect("setp.hi.u32 %p3, %r0, %r1;", "%p3", on<u32>([](u32 a, u32 b) { return a > b; }));
  bench.expect("setp.hs.u32 %p3, %r0, %r1;", "%p3", on<u32>([](u32 a, u32 b) { return a >= b; }));
  bench.expect("setp.lt.s16 %p3, %h0, %h1;", "%p3",
               on<std::int16_t>([](std::int16_t a, std::int16_t b) { return a < b; }));
  // Combined with a third predicate, and both results.
  bench.expect("setp.lt.and.s32 %p3|%p4, %r0, %r1, %p2;", "%p3",
               on<i32>([](i32 a, i32 b, i32 c) { return a < b && (c & 1); }));
  bench.expect("setp.lt.and.s32 %p3|%p4, %r0, %r1, %p2;", "%p4",
               on<i32>([](i32 a, i32 b, i32 c) { return !(a < b) && (c & 1); }));
  bench.expect("setp.lt.or.s32 %p3|%p4, %r0, %r1, !%p2;", "%p4",
               on<i32>([](i32 a, i32 b, i32 c) { return !(a < b) || !(c & 1); }));
  bench.expect("setp.eq.xor.b32 %p3, %r0, %r1, %p2;", "%p3",
               on<i32>([](i32 a, i32 b, i32 c) { return (a == b) != ((c & 1) != 0); }));
  bench.expect("setp.eq.s32 %p0|%p3, %r0, %r1;", "%p3", on<i32>([](i32 a, i32 b) { return a != b; }));
  bench.expect("set.gt.u32.s32 %r3, %r0, %r1;", "%r3",
               on<i32>([](i32 a, i32 b) { return a > b ? ~0u : 0u; }));
  bench.expect("set.gt.f32.s32 %f3, %r0, %r1;", "%f3",
               on<i32>([](i32 a, i32 b) { return a > b ? 1.0f : 0.0f; }));
  bench.expect("set.gt.and.u32.u32 %r3, %r0, %r1, %p2;", "%r3",
               on<u32>([](u32 a, u32 b, u32 c) { return a > b && (c & 1) ? ~0u : 0u; }));
  bench.expect("selp.b32 %r3, %r0, %r1, %p2;", "%r3",
               on<u32>([](u32 a, u32 b, u32 c) { return c & 1 ? a : b; }));
  bench.expect("selp.b64 %d3, %d0, %d1, !%p2;", "%d3",
               on<u64>([](u64 a, u64 b, u64 c) { return c & 1 ? b : a; }));
  bench.expect("slct.u32.s32 %r3, %r0, %r1, %r2;", "%r3",
               on<u32>([](u32 a, u32 b, u32 c) { return static_cast<i32>(c) >= 0 ? a : b; }));
  bench.run(integer_inputs());
}

TEST(EmitCompare, FloatsOrderedAndUnordered) {
  InstructionBench bench;
  const auto add = [&bench](const std::string& name, auto compare) {
    bench.expect(fmt::format("setp.{}.f32 %p3, %f0, %f1;", name), "%p3",
                 on<float>([compare](float a, float b) { return !std::isunordered(a, b) && compare(a, b); }));
    bench.expect(fmt::format("setp.{}u.f32 %p3, %f0, %f1;", name), "%p3",
                 on<float>([compare](float a, float b) { return std::isunordered(a, b) || compare(a, b); }));
  };
  add("eq", [](float a, float b) { return a == b; });
  add("ne", [](float a, float b) { return a != b; });
  add("lt", [](float a, float b) { return a < b; });
  add("le", [](float a, float b) { return a <= b; });
  add("gt", [](float a, float b) { return a > b; });
  add("ge", [](float a, float b) { return a >= b; });
  bench.expect("setp.num.f32 %p3, %f0, %f1;", "%p3",
               on<float>([](float a, float b) { return !std::isunordered(a, b); }));
  bench.expect("setp.nan.f32 %p3, %f0, %f1;", "%p3",
               on<float>([](float a, float b) { return std::isunordered(a, b); }));
  bench.expect("setp.lt.ftz.f32 %p3, %f0, 0f00800000;", "%p3",
               on<float>([](float a) { return a < std::numeric_limits<float>::min(); }));
  bench.expect("setp.gt.ftz.f32 %p3, %f0, 0f00000000;", "%p3",
               on<float>([](float a) { return a >= std::numeric_limits<float>::min(); }));
  bench.expect("selp.f32 %f3, %f0, %f1, %p2;", "%f3",
               [](const BenchInputs& in) { return in.c & 1 ? in.a : in.b; });
  bench.expect("slct.f32.f32 %f3, %f0, %f1, %f2;", "%f3",
               on<float>([](float a, float b, float c) { return c >= 0 ? a : b; }));
  bench.expect("set.le.u32.f32 %r3, %f0, %f1;", "%r3",
               on<float>([](float a, float b) { return a <= b ? ~0u : 0u; }));
  bench.run(float_inputs());
}

TEST(EmitCompare, Doubles) {
  InstructionBench bench;
  bench.expect("setp.leu.f64 %p3, %g0, %g1;", "%p3", on<double>([](double a, double b) { return !(a > b); }));
  bench.expect("setp.lt.f64 %p3, %g0, %g1;", "%p3", on<double>([](double a, double b) { return a < b; }));
  bench.run(double_inputs());
}

}  // namespace
}  // namespace warpgrain::profiler
