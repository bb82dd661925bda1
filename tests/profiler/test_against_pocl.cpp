// Kernels whose work is exact, so that the translated PTX must leave the same bytes as PoCL, which shares
// nothing with it but the front end's language. PoCL and the profiler each bring an LLVM into this process,
// and take turns.

#include "tests/profiler/against_pocl.hpp"

namespace warpgrain::profiler {
namespace {

TEST(AgainstPocl, BranchesLoopsAndIntegerWork) {
  expect_same(R"(
kernel void k(global const uint* in, global uint* out) {
  uint i = get_global_id(0), x = in[i], y = 0;
  for (uint n = x % 37; n > 0; --n) {
    if ((x & n) == 3) { x = x * 1664525u + 1013904223u; continue; }
    for (int m = 0; m < (int)(n & 7); ++m) {
      if (popcount(x) == 20) break;
      y += rotate(x, n) ^ mul_hi(x, (uint)m);
      x ^= x << 13; x ^= x >> 17; x ^= x << 5;
    }
    if (y % 1001 == 7) goto out;
    y -= clz(x) + (x / (n + 1)) + (y % (n + 2)) + ((int)x >> n) / 3;
  }
out:
  out[i] = y + abs_diff(x, y);
})",
              line_of(4096, 128));
}

TEST(AgainstPocl, SwitchesSparseAndDense) {
  expect_same(R"(
kernel void k(global const uint* in, global uint* out) {
  uint i = get_global_id(0), x = in[i], r = 1;
  for (int step = 0; step < 9; ++step) {
    switch (x % 11) {
      case 0: r += 3; break;
      case 1: r ^= x;
      case 2: r = r * 5 + 1; break;
      case 3: if (r & 1) break; r += x; break;
      case 4: out[i] = r; continue;
      case 5: r -= 77; break;
      case 6: r = ~r; break;
      case 7: r += out[i]; break;
      case 8: return;
      default: r = r * 31 + x;
    }
    switch (r) { case 17: x += 3; break; case 123456: x -= 9; break; case 0xffffffffu: x = 0; }
    x = x / 3 + r;
  }
  out[i] = r;
})",
              line_of(4096, 64));
}

TEST(AgainstPocl, ThreeDimensions) {
  expect_same(R"(
kernel void k(global const uint* in, global uint* out) {
  size_t x = get_global_id(0), y = get_global_id(1), z = get_global_id(2);
  size_t i = (z * get_global_size(1) + y) * get_global_size(0) + x;
  out[i] = in[i] + get_local_id(0) * 3 + get_local_id(1) * 5 + get_local_id(2) * 7 + get_group_id(0) * 11 +
           get_group_id(1) * 13 + get_group_id(2) * 17 + get_num_groups(1) * 19 + get_local_size(2) + get_global_offset(0);
})",
              {{16, 8, 32}, {4, 2, 8}});
}

TEST(AgainstPocl, BitonicSortInLocalMemory) {
  expect_same(R"(
kernel void k(global const uint* in, global uint* out, local uint* keys) {
  uint l = get_local_id(0), n = get_local_size(0);
  keys[l] = in[get_global_id(0)];
  for (uint size = 2; size <= n; size <<= 1)
    for (uint stride = size >> 1; stride > 0; stride >>= 1) {
      barrier(CLK_LOCAL_MEM_FENCE);
      uint other = l ^ stride;
      if (other > l) {
        bool up = (l & size) == 0;
        uint a = keys[l], b = keys[other];
        if ((a > b) == up) { keys[l] = b; keys[other] = a; }
      }
    }
  barrier(CLK_LOCAL_MEM_FENCE);
  out[get_global_id(0)] = keys[l];
})",
              line_of(4096, 256), {KernelArgument::local(256 * 4)});
}

TEST(AgainstPocl, LocalReductionWithAtomics) {
  expect_same(R"(
kernel void k(global uint* in, global uint* out) {
  local uint sum, most; local int least;
  if (get_local_id(0) == 0) { sum = 0; most = 0; least = 0x7fffffff; }
  barrier(CLK_LOCAL_MEM_FENCE);
  uint x = in[get_global_id(0)];
  atomic_add(&sum, x); atomic_max(&most, x); atomic_min(&least, (int)x);
  atomic_inc(&out[4000]); atomic_xor(&out[4001], x); atomic_cmpxchg((volatile global int*)&out[4002], 0, 1);
  barrier(CLK_LOCAL_MEM_FENCE);
  if (get_local_id(0) == 0) { out[3 * get_group_id(0)] = sum; out[3 * get_group_id(0) + 1] = most; out[3 * get_group_id(0) + 2] = least; }
})",
              line_of(4096, 128));
}

struct Plan {
  std::int8_t small;
  std::int16_t medium;
  std::int64_t large;
  float scale;
  std::uint32_t table[5];
};

TEST(AgainstPocl, StructsByValueTablesAndSmallScalars) {
  const Plan plan{-5, 1234, -123456789012345, 0.25f, {9, 8, 7, 6, 5}};
  expect_same(R"(
typedef struct { char small; short medium; long large; float scale; uint table[5]; } Plan;
constant uchar primes[8] = {2, 3, 5, 7, 11, 13, 17, 19};
constant Plan fixed_plan = {1, -2, 3000000000, 0.5f, {1, 2, 3, 4, 5}};
uint weigh(const Plan* plan, uint i) { return plan->table[i % 5] * primes[i & 7] + (uint)(plan->large >> (i & 31)); }
kernel void k(global const uint* in, global uint* out, Plan plan, uchar flag, short bias, constant uint* more) {
  uint i = get_global_id(0);
  uint stack[8];
  for (int j = 0; j < 8; ++j) stack[j] = in[(i + j) & 4095];
  Plan mine = i & 1 ? plan : fixed_plan;
  uint r = weigh(&mine, in[i]) + stack[in[i] & 7] + flag * bias + (uint)mine.small + (uint)mine.medium;
  r += as_uint(mine.scale * (float)(in[i] & 0xffff)) + more[i & 3];
  out[i] = r;
})",
              line_of(4096, 64), [&] {
                static std::vector<std::uint32_t> more{1000, 2000, 3000, 4000};
                return std::vector<KernelArgument>{scalar_of(plan), scalar_of(std::uint8_t{200}),
                                                   scalar_of(std::int16_t{-321}), buffer_of(more)};
              }());
}

TEST(AgainstPocl, ExactFloatWork) {
  // Sums and products that need no rounding, so that no order and no fusing of them shows.
  expect_same(R"(
kernel void k(global const uint* in, global uint* out) {
  uint i = get_global_id(0);
  float4 v = convert_float4((int4)((int)(in[i] & 63) - 32, in[i] >> 8 & 31, in[i] >> 16 & 15, 3));
  float parts[4] = {v.y, 2.0f, -v.x, 0.5f};
  float4 w = vload4(0, parts);
  float d = dot(v, w) + fma(v.x, w.y, -v.z) + mad(w.z, 2.0f, v.w);
  float3 c = cross(v.xyz, w.xyz);
  float m = clamp(fmax(c.x, c.y), -64.0f, 64.0f) + fmin(c.z, d) + fabs(d) + sqrt(v.w * 12.0f) + floor(d / 4.0f);
  m = select(m, d, isless(m, d)) + step(0.0f, d) + sign(c.x) + convert_int_rte(d * 0.25f) + convert_uchar_sat(c.y);
  double e = (double)m * 0.5 + 1.0; e = sqrt(e * e) + fma(e, e, 1.0);
  out[i] = as_uint(m) ^ convert_uint_sat(e);
  vstore2((short2)((short)d, (short)m), i, (global short*)out);
  out[i] += as_uint(m);
})",
              line_of(4096, 64));
}

// Both bring their LLVM's global state, whichever comes first; this one alone begins with the profiler's.
TEST(AgainstPocl, TurnsInOneProcess) {
  const std::string source =
      "kernel void k(global const uint* in, global uint* out) { out[get_global_id(0)] = in[get_global_id(0)] "
      "* %d; }";
  for (int turn = 1; turn <= 3; ++turn) {
    std::string text = source;
    text.replace(text.find("%d"), 2, std::to_string(turn));
    expect_same(text, line_of(4096, 64));
    Pocl another;
    std::vector<std::uint32_t> in = random_words(64), out(64);
    another.run(text, "k", line_of(64, 64), {buffer_of(in), buffer_of(out)});
    EXPECT_EQ(out[5], in[5] * static_cast<std::uint32_t>(turn));
  }
}

TEST(AgainstPocl, PoclFirst) {
  Pocl first;
  std::vector<std::uint32_t> in = random_words(64), out(64);
  const std::string source =
      "kernel void k(global const uint* in, global uint* out) { out[get_global_id(0)] = "
      "~in[get_global_id(0)]; }";
  first.run(source, "k", line_of(64, 64), {buffer_of(in), buffer_of(out)});
  EXPECT_EQ(out[7], ~in[7]);
  expect_same(source, line_of(4096, 64));
}

}  // namespace
}  // namespace warpgrain::profiler
