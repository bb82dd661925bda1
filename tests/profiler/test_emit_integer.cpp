#include "tests/profiler/instruction_bench.hpp"

namespace warpgrain::profiler {
namespace {

using i8 = std::int8_t;
using u8 = std::uint8_t;
using i16 = std::int16_t;
using u16 = std::uint16_t;
using i32 = std::int32_t;
using u32 = std::uint32_t;
using u64 = std::uint64_t;

// The sum of products of the packed elements, from element `first` of b on.
template <class A, class B>
u32 dot(u32 a, u32 b, u32 c, unsigned first) {
  u32 sum = c;
  for (unsigned i = 0; i < 4 / sizeof(A); ++i)
    sum += static_cast<u32>(i32{static_cast<A>(a >> (8 * sizeof(A) * i))} *
                            i32{static_cast<B>(b >> (8 * (first + i)))});
  return sum;
}

TEST(EmitInteger, DotProductsOfPackedValues) {
  InstructionBench bench;
  const auto add = [&bench](const std::string& code, auto reference) {
    bench.expect(code + " %r3, %r0, %r1, %r2;", "%r3", on<u32>(reference));
  };
  add("dp4a.u32.u32", [](u32 a, u32 b, u32 c) { return dot<u8, u8>(a, b, c, 0); });
  add("dp4a.s32.s32", [](u32 a, u32 b, u32 c) { return dot<i8, i8>(a, b, c, 0); });
  add("dp4a.s32.u32", [](u32 a, u32 b, u32 c) { return dot<i8, u8>(a, b, c, 0); });
  add("dp4a.u32.s32", [](u32 a, u32 b, u32 c) { return dot<u8, i8>(a, b, c, 0); });
  add("dp2a.lo.s32.u32", [](u32 a, u32 b, u32 c) { return dot<i16, u8>(a, b, c, 0); });
  add("dp2a.hi.u32.s32", [](u32 a, u32 b, u32 c) { return dot<u16, i8>(a, b, c, 2); });
  bench.run(integer_inputs());
}

u32 ones(u64 count) { return static_cast<u32>((u64{1} << count) - 1); }

u32 extended(u32 a, u32 count, bool is_signed) {
  if (count == 0) return 0;
  const u32 kept = a & ones(count);
  return is_signed && (a >> (count - 1) & 1) != 0 ? kept | ~ones(count) : kept;
}

TEST(EmitInteger, MasksAndExtensions) {
  InstructionBench bench;
  bench.expect("bmsk.clamp.b32 %r3, %r0, %r1;", "%r3", on<u32>([](u32 a, u32 b) {
                 return a > 31 ? 0u : static_cast<u32>(u64{ones(std::min(b, 32u))} << a);
               }));
  bench.expect("bmsk.wrap.b32 %r3, %r0, %r1;", "%r3",
               on<u32>([](u32 a, u32 b) { return static_cast<u32>(u64{ones(b & 31)} << (a & 31)); }));
  bench.expect("szext.clamp.u32 %r3, %r0, %r1;", "%r3",
               on<u32>([](u32 a, u32 b) { return extended(a, std::min(b, 32u), false); }));
  bench.expect("szext.clamp.s32 %r3, %r0, %r1;", "%r3",
               on<u32>([](u32 a, u32 b) { return extended(a, std::min(b, 32u), true); }));
  bench.expect("szext.wrap.s32 %r3, %r0, %r1;", "%r3",
               on<u32>([](u32 a, u32 b) { return extended(a, b & 31, true); }));
  bench.run(integer_inputs());
}

TEST(EmitInteger, TheNthSetBit) {
  InstructionBench bench;
  bench.expect("and.b32 %r3, %r1, 31; fns.b32 %r4, %r0, %r3, 2;", "%r4", on<u32>([](u32 a, u32 b) {
                 unsigned found = 0;
                 for (u32 i = b & 31; i < 32; ++i)
                   if ((a >> i & 1) != 0 && ++found == 2) return i;
                 return ~0u;
               }));
  bench.expect("and.b32 %r3, %r1, 31; fns.b32 %r4, %r0, %r3, -1;", "%r4", on<u32>([](u32 a, u32 b) {
                 for (i32 i = static_cast<i32>(b & 31); i >= 0; --i)
                   if ((a >> i & 1) != 0) return static_cast<u32>(i);
                 return ~0u;
               }));
  bench.expect("and.b32 %r3, %r1, 31; fns.b32 %r4, %r0, %r3, 0;", "%r4",
               on<u32>([](u32 a, u32 b) { return (a >> (b & 31) & 1) != 0 ? b & 31 : ~0u; }));
  bench.run(integer_inputs());
}

}  // namespace
}  // namespace warpgrain::profiler
