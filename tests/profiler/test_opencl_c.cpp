// OpenCL C's types and functions beyond arithmetic, on random input, against PoCL.

#include "tests/profiler/against_pocl.hpp"

namespace warpgrain::profiler {
namespace {

const std::vector<std::string> widths{"2", "3", "4", "8", "16"};

// `text` with every $ replaced.
std::string with(std::string text, const std::string& replacement) {
  for (std::size_t at = text.find('$'); at != std::string::npos; at = text.find('$', at + replacement.size()))
    text.replace(at, 1, replacement);
  return text;
}

// Each lane stores to elements of its own: PoCL may run lanes in any order.
TEST(OpenclC, LoadsAndStoresOfVectorsInEverySpace) {
  for (const std::string type : {"uchar", "short", "uint", "long"}) {
    std::string body;
    for (const std::string& width : widths)
      body += with(
          "vstore$(vload$(place, mine) + vload$(place, (const global T*)in) - vload$(place, shared), "
          "16 / $ - 1, (global T*)out + 16 * i);\n"
          "vstore$(vload$(place + 1, shared), place, mine);\n",
          width);
    expect_same("#define T " + type + R"(
kernel void k(global const uint* in, global uint* out) {
  const uint i = get_global_id(0), place = in[i] & 1;
  local T shared[64];
  T mine[64];
  for (int j = 0; j < 64; ++j) mine[j] = in[j] * (i + 1), shared[j] = in[j + 7];
  barrier(CLK_LOCAL_MEM_FENCE);
)" + body + "vstore4(*(uint4*)mine, i, out + 2048);\n}",
                line_of(64, 1));
  }
}

TEST(OpenclC, CopiesWithEvents) {
  for (const std::string type : {"uchar", "short3", "uint", "int2", "ulong4", "float", "uchar16"})
    expect_same("#define T " + type + R"(
kernel void k(global const uint* in, global uint* out, local T* tile) {
  const uint l = get_local_id(0), group = get_group_id(0);
  event_t e[2];
  e[0] = async_work_group_copy(tile, (const global T*)in + group * 20, 13, 0);
  e[1] = async_work_group_strided_copy(tile + 13, (const global T*)in, 7, 3, 0);
  prefetch((const global T*)in, 16);
  wait_group_events(2, e);
  const T kept = tile[(l * 7) % 20];
  barrier(CLK_LOCAL_MEM_FENCE);
  tile[l] = kept;
  barrier(CLK_LOCAL_MEM_FENCE);
  event_t back = async_work_group_copy((global T*)out + group * 20, tile, 8, 0);
  back = async_work_group_strided_copy((global T*)out + 100 + group, tile, 5, 4, back);
  wait_group_events(1, &back);
})",
                line_of(32, 8), {KernelArgument::local(20 * 64)});
}

// A kernel with this body and `sum` of type T, of which functions fold2 to fold16 make one number of a
// vector.
std::string folding_kernel(const std::string& type, const std::string& body) {
  return "typedef " + type + " T;\n" +
         with("typedef $2 T2; typedef $3 T3; typedef $4 T4; typedef $8 T8; typedef $16 T16;", type) + R"(
T fold2(T2 v) { return v.x * (T)7 + v.y; }
T fold3(T3 v) { return v.x * (T)7 + v.y * (T)11 + v.z; }
T fold4(T4 v) { return fold2(v.lo) * (T)13 + fold2(v.hi); }
T fold8(T8 v) { return fold4(v.lo) * (T)17 + fold4(v.hi); }
T fold16(T16 v) { return fold8(v.lo) * (T)19 + fold8(v.hi); }
kernel void k(global const uint* in, global uint* out) {
  const uint i = get_global_id(0);
  T sum = 0;
)" + body +
         "((global T*)out)[i] = sum;\n}";
}

// A kernel for each width that is shuffled: one of all takes ten times as long to compile.
TEST(OpenclC, Shuffles) {
  for (const std::string type : {"uchar", "ulong"})
    for (const std::string from : {"2", "4", "8", "16"}) {
      std::string body;
      for (const std::string to : {"2", "4", "8", "16"})
        body += "{ const T" + from + " x = vload" + from + "(i, (const global T*)in), y = vload" + from +
                "(i + 3, (const global T*)in); const T" + to + " m = vload" + to +
                "(i + 5, (const global T*)in);\n  const T" + to +
                " r = shuffle(x, m) + shuffle2(x, y, m) * (T)3; sum ^= fold" + to + "(r); }\n";
      expect_same(folding_kernel(type, body), line_of(64, 16));
    }
}

TEST(OpenclC, Selections) {
  for (const std::string type : {"uchar", "ulong"}) {
    std::string body;
    for (const std::string& width : widths)
      body += with(
          "{ const T$ x = vload$(i, (const global T*)in), y = vload$(i + 3, (const global T*)in), z = "
          "vload$(i + 5, (const global T*)in);\n"
          "  sum = sum * (T)5 + fold$(select(x, y, z)) + fold$(bitselect(x, y, z)); }\n",
          width);
    expect_same(folding_kernel(type, body), line_of(64, 16));
  }
}

TEST(OpenclC, AtomicsOf64Bits) {
  for (const std::string type : {"long", "ulong"})
    expect_same(
        "#pragma OPENCL EXTENSION cl_khr_int64_base_atomics : enable\n"
        "#pragma OPENCL EXTENSION cl_khr_int64_extended_atomics : enable\n#define T " +
            type + R"(
kernel void k(global const uint* in, global uint* out) {
  const uint i = get_global_id(0);
  local T shared[8];
  const T value = (T)in[2 * i] << 32 | in[2 * i + 1];
  volatile global T* all = (volatile global T*)out;
  if (get_local_id(0) < 8) shared[get_local_id(0)] = 1;
  barrier(CLK_LOCAL_MEM_FENCE);
  atom_add(&all[0], value); atom_sub(&all[1], value); atom_inc(&all[2]); atom_dec(&all[3]);
  atom_min(&all[4], value); atom_max(&all[5], value); atom_or(&all[6], value); atom_xor(&all[7], value);
  atom_and(&shared[0], value); atom_add(&shared[1], value); atom_min(&shared[2], value); atom_max(&shared[3], value);
  if (i == 5) { all[8] = atom_xchg(&shared[4], value); all[9] = atom_cmpxchg(&shared[4], value, (T)7); all[10] = atom_cmpxchg(&shared[4], value, (T)8); }
  barrier(CLK_LOCAL_MEM_FENCE);
  if (get_local_id(0) < 5) all[16 + get_group_id(0) * 5 + get_local_id(0)] = shared[get_local_id(0)];
})",
        line_of(256, 64));
}

TEST(OpenclC, ConstantsAndPointersToThem) {
  expect_same(R"(
constant uint primes[] = {2, 3, 5, 7, 11, 13, 17, 19};
constant uint* constant from_third = &primes[2];
constant struct { constant char* name; short value; } table[] = {{"warp", 1}, {"grain", -2}, {"", 3}};
constant float4 quads[2] = {(float4)(1, 2, 3, 4), (float4)(0.5f)};
constant ulong big = 1ul << 63;
constant char words[3][4] = {"ab", "cd", {'x', 0, 'y'}};
uint length(constant char* text) { uint n = 0; while (text[n]) ++n; return n; }
kernel void k(global const uint* in, global uint* out) {
  const uint i = get_global_id(0), x = in[i];
  constant uint* place = x & 1 ? from_third : primes;
  out[i] = place[x >> 1 & 3] + length(table[x % 3].name) + table[x % 3].value + (uint)quads[x >> 5 & 1][x >> 7 & 3] +
           (uint)(big >> (x & 63)) + words[x % 3][x >> 3 & 3];
})",
              line_of(1024, 64));
}

// What OpenCL C 1.2 has no word for: PoCL of Debian 12 takes no half arithmetic, so the work is undone by
// exact means.
TEST(OpenclC, HalfArithmeticOfSmallWholeNumbersIsExact) {
  std::vector<std::uint32_t> in = random_words(512), out(512);
  run_launch(*compile_kernel(R"(
#pragma OPENCL EXTENSION cl_khr_fp16 : enable
typedef struct { half a; half3 b; } Pair;
half half_of(Pair p) { return p.a * p.b.y - p.b.z; }
kernel void k(global const uint* in, global uint* out, half scale, half2 both) {
  const uint i = get_global_id(0);
  half2 v = convert_half2((uint2)(in[i] & 15, in[i] >> 4 & 15));
  Pair p = {v.x, (half3)(1, v.y, scale)};
  half4 w = (half4)(v, v.yx) + (half4)(both, both);
  local half tile[64];
  tile[get_local_id(0)] = w.w;
  barrier(CLK_LOCAL_MEM_FENCE);
  half r = half_of(p) + fma(w.x, w.y, tile[get_local_id(0) ^ 1]) + max(w.z, (half)3) + sqrt((half)49) + floor(v.x / 2) + dot(v, both);
  r = isless(v.x, v.y) ? -r : r;
  out[i] = convert_int_sat(r);
})",
                             "k"),
             line_of(512, 64),
             {buffer_of(in), buffer_of(out), scalar_of(std::uint16_t{0x4200}),
              scalar_of(std::uint32_t{0x40003c00})});
  for (std::size_t i = 0; i < in.size(); ++i) {
    const auto x = [&](std::size_t at) { return static_cast<int>(in[at] & 15); };
    const auto y = [&](std::size_t at) { return static_cast<int>(in[at] >> 4 & 15); };
    const int tile = x(i ^ 1) + 2;
    int r = x(i) * y(i) - 3 + (x(i) + 1) * (y(i) + 2) + tile + std::max(y(i) + 1, 3) + 7 + x(i) / 2 + x(i) +
            2 * y(i);
    if (x(i) < y(i)) r = -r;
    ASSERT_EQ(static_cast<int>(out[i]), r) << "work-item " << i << " seed " << pocl_seed;
  }
}

}  // namespace
}  // namespace warpgrain::profiler
