#include <array>
#include <bit>

#include "tests/profiler/instruction_bench.hpp"

namespace warpgrain::profiler {
namespace {

using i32 = std::int32_t;
using u16 = std::uint16_t;
using i16 = std::int16_t;
using u32 = std::uint32_t;
using i64 = std::int64_t;
using u64 = std::uint64_t;

u64 reversed(u64 value, int bits) {
  u64 result = 0;
  for (int i = 0; i < bits; ++i) result |= (value >> i & 1) << (bits - 1 - i);
  return result;
}

// bfe as the PTX manual defines it, bit by bit.
u64 extracted(u64 value, u64 position, u64 length, bool is_signed, unsigned bits) {
  position &= 255;
  length &= 255;
  const unsigned top = bits - 1;
  const u64 sign = !is_signed || length == 0 ? 0 : value >> std::min<u64>(position + length - 1, top) & 1;
  u64 result = 0;
  for (unsigned i = 0; i < bits; ++i)
    result |= (i < length && position + i <= top ? value >> (position + i) & 1 : sign) << i;
  return result;
}

u64 inserted(u64 field, u64 base, u64 position, u64 length, unsigned bits) {
  position &= 255;
  length &= 255;
  u64 result = base;
  for (u64 i = 0; i < length && position + i < bits; ++i) {
    result &= ~(u64{1} << (position + i));
    result |= (field >> i & 1) << (position + i);
  }
  return result;
}

TEST(EmitBits, Logic) {
  InstructionBench bench;
  bench.expect("and.b32 %r3, %r0, %r1;", "%r3", on<u32>([](u32 a, u32 b) { return a & b; }));
  bench.expect("or.b64 %d3, %d0, %d1;", "%d3", on<u64>([](u64 a, u64 b) { return a | b; }));
  bench.expect("xor.b16 %h3, %h0, %h1;", "%h3",
               on<u16>([](u16 a, u16 b) { return static_cast<u16>(a ^ b); }));
  bench.expect("not.b32 %r3, %r0;", "%r3", on<u32>([](u32 a) { return ~a; }));
  bench.expect("cnot.b32 %r3, %r0;", "%r3", on<u32>([](u32 a) { return u32{a == 0}; }));
  bench.expect("and.pred %p3, %p0, %p1;", "%p3", on<u32>([](u32 a, u32 b) { return a & b & 1; }));
  bench.expect("or.pred %p3, %p0, !%p1;", "%p3", on<u32>([](u32 a, u32 b) { return (a | ~b) & 1; }));
  bench.expect("xor.pred %p3, %p0, %p1;", "%p3", on<u32>([](u32 a, u32 b) { return (a ^ b) & 1; }));
  bench.expect("not.pred %p3, %p0;", "%p3", on<u32>([](u32 a) { return ~a & 1; }));
  bench.expect("lop3.b32 %r3, %r0, %r1, %r2, 0x96;", "%r3",
               on<u32>([](u32 a, u32 b, u32 c) { return a ^ b ^ c; }));
  bench.expect("lop3.b32 %r3, %r0, %r1, %r2, 0xE8;", "%r3",
               on<u32>([](u32 a, u32 b, u32 c) { return (a & b) | (a & c) | (b & c); }));
  bench.expect("lop3.b32 %r3, %r0, %r1, %r2, 0xCA;", "%r3",
               on<u32>([](u32 a, u32 b, u32 c) { return (a & b) | (~a & c); }));
  bench.run(integer_inputs());
}

TEST(EmitBits, ShiftsClampTheirAmount) {
  InstructionBench bench;
  bench.expect("shl.b32 %r3, %r0, %r1;", "%r3", on<u32>([](u32 a, u32 b) { return b < 32 ? a << b : 0; }));
  bench.expect("shl.b64 %d3, %d0, %r1;", "%d3", [](const BenchInputs& in) {
    const u32 n = from_bits<u32>(in.b);
    return n < 64 ? in.a << n : 0;
  });
  bench.expect("shr.u32 %r3, %r0, %r1;", "%r3", on<u32>([](u32 a, u32 b) { return b < 32 ? a >> b : 0; }));
  bench.expect("shr.s32 %r3, %r0, %r1;", "%r3",
               on<i32>([](i32 a, i32 b) { return a >> std::min<u32>(static_cast<u32>(b), 31); }));
  bench.expect("shr.s64 %d3, %d0, %r1;", "%d3", [](const BenchInputs& in) {
    return static_cast<u64>(static_cast<i64>(in.a) >> std::min<u32>(from_bits<u32>(in.b), 63));
  });
  bench.expect("shl.b16 %h3, %h0, %r1;", "%h3", [](const BenchInputs& in) {
    const u32 n = from_bits<u32>(in.b);
    return n < 16 ? u64{static_cast<u16>(in.a << n)} : 0;
  });
  bench.expect("shr.s16 %h3, %h0, %r1;", "%h3", [](const BenchInputs& in) {
    return u64{static_cast<u16>(from_bits<i16>(in.a) >> std::min<u32>(from_bits<u32>(in.b), 15))};
  });
  bench.expect("shl.b32 %r3, %r0, 40;", "%r3", on<u32>([](u32) { return 0u; }));
  const auto pair = [](u32 a, u32 b) { return u64{b} << 32 | a; };
  bench.expect("shf.l.wrap.b32 %r3, %r0, %r1, %r2;", "%r3", on<u32>([pair](u32 a, u32 b, u32 c) {
                 return static_cast<u32>(pair(a, b) << (c & 31) >> 32);
               }));
  bench.expect("shf.r.wrap.b32 %r3, %r0, %r1, %r2;", "%r3",
               on<u32>([pair](u32 a, u32 b, u32 c) { return static_cast<u32>(pair(a, b) >> (c & 31)); }));
  bench.expect("shf.l.clamp.b32 %r3, %r0, %r1, %r2;", "%r3", on<u32>([pair](u32 a, u32 b, u32 c) {
                 return static_cast<u32>(pair(a, b) << std::min(c, 32u) >> 32);
               }));
  bench.expect("shf.r.clamp.b32 %r3, %r0, %r1, %r2;", "%r3", on<u32>([pair](u32 a, u32 b, u32 c) {
                 return static_cast<u32>(pair(a, b) >> std::min(c, 32u));
               }));
  bench.run(integer_inputs());
}

TEST(EmitBits, FieldsOfEveryPositionAndLength) {
  InstructionBench bench;
  bench.expect("bfe.u32 %r3, %r0, %r1, %r2;", "%r3",
               on<u32>([](u32 a, u32 b, u32 c) { return static_cast<u32>(extracted(a, b, c, false, 32)); }));
  bench.expect("bfe.s32 %r3, %r0, %r1, %r2;", "%r3",
               on<u32>([](u32 a, u32 b, u32 c) { return static_cast<u32>(extracted(a, b, c, true, 32)); }));
  bench.expect("bfe.s64 %d3, %d0, %r1, %r2;", "%d3",
               [](const BenchInputs& in) { return extracted(in.a, in.b, in.c, true, 64); });
  bench.expect("bfe.u32 %r3, %r0, 8, 8;", "%r3", on<u32>([](u32 a) { return a >> 8 & 255; }));
  bench.expect("bfi.b32 %r3, %r0, %r1, %r2, %r1;", "%r3",
               on<u32>([](u32 a, u32 b, u32 c) { return static_cast<u32>(inserted(a, b, c, b, 32)); }));
  bench.expect("bfi.b64 %d3, %d0, %d1, 13, 40;", "%d3",
               [](const BenchInputs& in) { return inserted(in.a, in.b, 13, 40, 64); });
  bench.run(integer_inputs());
}

TEST(EmitBits, CountsAndPermutations) {
  InstructionBench bench;
  bench.expect("popc.b32 %r3, %r0;", "%r3", on<u32>([](u32 a) { return std::popcount(a); }));
  bench.expect("popc.b64 %r3, %d0;", "%r3", on<u64>([](u64 a) { return std::popcount(a); }));
  bench.expect("clz.b32 %r3, %r0;", "%r3", on<u32>([](u32 a) { return std::countl_zero(a); }));
  bench.expect("clz.b64 %r3, %d0;", "%r3", on<u64>([](u64 a) { return std::countl_zero(a); }));
  bench.expect("brev.b32 %r3, %r0;", "%r3", on<u32>([](u32 a) { return static_cast<u32>(reversed(a, 32)); }));
  bench.expect("brev.b64 %d3, %d0;", "%d3", on<u64>([](u64 a) { return reversed(a, 64); }));
  bench.expect("bfind.u32 %r3, %r0;", "%r3", on<u32>([](u32 a) { return 31 - std::countl_zero(a); }));
  bench.expect("bfind.s32 %r3, %r0;", "%r3",
               on<u32>([](u32 a) { return 31 - std::countl_zero(a >> 31 ? ~a : a); }));
  bench.expect("bfind.shiftamt.u64 %r3, %d0;", "%r3",
               on<u64>([](u64 a) { return a == 0 ? -1 : std::countl_zero(a); }));
  bench.expect("prmt.b32 %r3, %r0, %r1, %r2;", "%r3", on<u32>([](u32 a, u32 b, u32 c) {
                 const u64 bytes = u64{b} << 32 | a;
                 u32 result = 0;
                 for (int i = 0; i < 4; ++i) {
                   const u32 nibble = c >> (4 * i) & 15;
                   u32 byte = static_cast<u32>(bytes >> (8 * (nibble & 7))) & 255;
                   if (nibble & 8) byte = byte & 128 ? 255 : 0;
                   result |= byte << (8 * i);
                 }
                 return result;
               }));
  // Bytes of {b, a} by the mode and the low two bits of c, the highest first, as the manual's table has them.
  const auto chosen = [](u32 a, u32 b, const int(&bytes)[4]) {
    u32 result = 0;
    for (const int byte : bytes)
      result = result << 8 | (static_cast<u32>((u64{b} << 32 | a) >> (8 * byte)) & 255);
    return result;
  };
  const auto add = [&](const std::string& mode, const int(&rows)[4][4]) {
    std::vector<std::array<int, 4>> table;
    for (const auto& row : rows) table.push_back(std::to_array(row));
    bench.expect(fmt::format("prmt.b32.{} %r3, %r0, %r1, %r2;", mode), "%r3",
                 on<u32>([=](u32 a, u32 b, u32 c) {
                   const auto& row = table[c & 3];
                   return chosen(a, b, {row[0], row[1], row[2], row[3]});
                 }));
  };
  add("f4e", {{3, 2, 1, 0}, {4, 3, 2, 1}, {5, 4, 3, 2}, {6, 5, 4, 3}});
  add("b4e", {{5, 6, 7, 0}, {6, 7, 0, 1}, {7, 0, 1, 2}, {0, 1, 2, 3}});
  add("rc8", {{0, 0, 0, 0}, {1, 1, 1, 1}, {2, 2, 2, 2}, {3, 3, 3, 3}});
  add("ecl", {{3, 2, 1, 0}, {3, 2, 1, 1}, {3, 2, 2, 2}, {3, 3, 3, 3}});
  add("ecr", {{0, 0, 0, 0}, {1, 1, 1, 0}, {2, 2, 1, 0}, {3, 2, 1, 0}});
  add("rc16", {{1, 0, 1, 0}, {3, 2, 3, 2}, {1, 0, 1, 0}, {3, 2, 3, 2}});
  bench.run(integer_inputs());
}

}  // namespace
}  // namespace warpgrain::profiler
