#include "tests/profiler/instruction_bench.hpp"

namespace warpgrain::profiler {
namespace {

using u16 = std::uint16_t;
using u32 = std::uint32_t;
using i64 = std::int64_t;
using u64 = std::uint64_t;

TEST(EmitMove, PacksAndUnpacks) {
  InstructionBench bench;
  bench.expect("mov.b64 %d3, {%r0, %r1};", "%d3", on<u32>([](u32 a, u32 b) { return u64{b} << 32 | a; }));
  bench.expect("mov.b64 {%r3, %r4}, %d0;", "%r4", on<u64>([](u64 a) { return a >> 32; }));
  bench.expect("mov.b32 %r3, {%h0, %h1};", "%r3", on<u16>([](u16 a, u16 b) { return u32{b} << 16 | a; }));
  bench.expect("mov.b64 %d3, {%h0, %h1, %h2, %h0};", "%d3",
               on<u16>([](u16 a, u16 b, u16 c) { return u64{a} << 48 | u64{c} << 32 | u64{b} << 16 | a; }));
  bench.expect("mov.b64 {%h3, %h4, _, %h5}, %d0;", "%h5", on<u64>([](u64 a) { return a >> 48; }));
  bench.expect("mov.b32 %f3, %r0;", "%f3", on<u32>([](u32 a) { return a; }));
  bench.expect("mov.f32 %f3, 0f3FC00000;", "%f3", on<u32>([](u32) { return 1.5f; }));
  bench.expect("mov.f64 %g3, 2.5;", "%g3", on<u32>([](u32) { return 2.5; }));
  bench.expect("mov.u32 %r3, 0x1F;", "%r3", on<u32>([](u32) { return 31u; }));
  bench.expect("mov.u32 %r3, 017;", "%r3", on<u32>([](u32) { return 15u; }));
  bench.expect("mov.u32 %r3, 0b101U;", "%r3", on<u32>([](u32) { return 5u; }));
  bench.expect("mov.s64 %d3, -5;", "%d3", on<u32>([](u32) { return i64{-5}; }));
  bench.expect("mov.pred %p3, -1;", "%p3", on<u32>([](u32) { return true; }));
  bench.expect("mov.u32 %r3, WARP_SZ;", "%r3", on<u32>([](u32) { return 32u; }));
  bench.expect("mov.u32 %r3, %envreg3;", "%r3", on<u32>([](u32) { return 0u; }));
  bench.run(integer_inputs());
}

}  // namespace
}  // namespace warpgrain::profiler
