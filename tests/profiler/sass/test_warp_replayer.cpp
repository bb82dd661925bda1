// Kernels whose counts can be said by hand. What ptxas makes of them may change with its version: tests say
// how often instructions that it cannot drop are run, and by how many lanes at once.

#include <numeric>

#include "profiler/sass/warp_replayer.hpp"
#include "tests/profiler/sass/replayed_kernel.hpp"

namespace warpgrain::profiler::sass {
namespace {

class WarpReplayerTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!find_ptxas()) GTEST_SKIP() << no_ptxas;
  }

  // A warp of which lane k finds k + first in `in`.
  ReplayedKernel replay(const std::string& body, int first = 0, std::uint64_t size = 32) {
    in_.resize(size);
    std::iota(in_.begin(), in_.end(), first);
    out_.assign(4096, 1.5F);
    ReplayedKernel replayed(
        "kernel void k(global const int* restrict in, global float* out) {\n"
        "  const int i = get_global_id(0);\n  const int v = in[i];\n" +
            body + "}\n",
        "k", line_of(size, 32), {buffer_of(in_), buffer_of(out_)});
    replayed.expect_complete();
    return replayed;
  }

  std::vector<int> in_;
  std::vector<float> out_;
};

TEST_F(WarpReplayerTest, IfAndElseRunOneAfterTheOther) {
  // Loops, since ptxas puts what is short under a predicate.
  const ReplayedKernel r = replay(
      "float x = v;\nif (v < 10) { while (x < 20) { x += 1; out[i + 32 * (int)x] = x; } }\n"
      "else { while (x < 50) { x += 2; out[i + 32 * (int)x] = 7; } }\n");
  EXPECT_EQ(r.warps_at("STG"), 20U + 20U) << "as often as the longest of each side";
  EXPECT_EQ(r.lanes_at("STG"), 155U + 330U);
}

TEST_F(WarpReplayerTest, LoopsOfVaryingTripsGoOnUntilTheLongest) {
  // The trips cannot be counted beforehand, so no copy goes without its test.
  const ReplayedKernel r = replay("float x = v; while (x < 31) { x += 1; out[i + 32 * (int)x] = x; }\n");
  EXPECT_EQ(r.lanes_at("STG"), 31U * 32 / 2);
  EXPECT_EQ(r.warps_at("STG"), 31U);
}

TEST_F(WarpReplayerTest, TurnsAfterAYieldAreCounted) {
  // ptxas puts a YIELD into loops that read volatile memory.
  const ReplayedKernel r = replay(
      "float x = v; while (x < 31) { x += ((volatile global const int*)in)[0] + 1; out[i + 32 * (int)x] = x; "
      "}\nout[i] = x;\n");
  EXPECT_EQ(r.lanes_at("STG"), 31U * 32 / 2 + 32);
  if (r.warps_at("YIELD") == 0) GTEST_SKIP() << "this ptxas puts none there";
  EXPECT_GT(r.replay().turns_assumed, 0U);
}

TEST_F(WarpReplayerTest, NoTurnIsAssumedWithoutAYield) {
  const ReplayedKernel r = replay("float x = v; while (x < 31) { x += 1; out[i + 32 * (int)x] = x; }\n");
  EXPECT_EQ(r.warps_at("YIELD"), 0U);
  EXPECT_EQ(r.replay().turns_assumed, 0U);
}

TEST_F(WarpReplayerTest, LanesThatBreakWaitBehindTheLoop) {
  const ReplayedKernel r = replay(
      "float s = 0; for (int k = 0; k < 40; ++k) { const float x = out[k * 32 + i]; if (in[k % 32] == v) "
      "break;\n"
      "  s += x; out[k * 32 + i + 1] = s; }\nout[i] = s;\n");
  EXPECT_EQ(r.warps_at("EXIT"), 1U) << "they come together again";
  EXPECT_EQ(r.lanes_at("EXIT"), 32U);
}

TEST_F(WarpReplayerTest, LanesThatEndEarlyAreGone) {
  const ReplayedKernel r = replay("if (v >= 8) return;\nout[i] = v;\n");
  EXPECT_EQ(r.lanes_at("STG"), 8U);
  EXPECT_EQ(r.warps_at("STG"), 1U);
}

TEST_F(WarpReplayerTest, NestedBranches) {
  const ReplayedKernel r = replay(
      "if (v < 16) { out[i] = native_sin(out[i]); if (v < 4) { out[i + 32] = native_cos(out[i + 7]); out[i + "
      "33] = 1; out[i + 77] = 2; }\n"
      "  else { out[i + 64] = native_exp(out[i]); out[i + 99] = 7; out[i + 98] = out[i + 5]; } out[i + 200] "
      "= 1; }\n"
      "else { out[i] = 9; out[i + 300] = out[i + 301]; out[i + 400] = 4; }\n");
  EXPECT_EQ(r.lanes_at("STG"), 16U + 3 * 4 + 3 * 12 + 16 + 3 * 16);
}

TEST_F(WarpReplayerTest, SwitchesGoThroughATableOrATree) {
  const ReplayedKernel r = replay(
      "switch (v % 8) { case 0: out[i] = 1; break; case 1: out[i] = out[i + 1] * 3; break;\n"
      "case 2: out[i + 7] = out[i] / 7; break; case 3: out[i] = native_sin(out[i]); break;\n"
      "case 4: out[i + 9] = 9; break; case 5: out[i] *= out[i + 3]; break; case 6: break;\n"
      "default: out[i + 3] = 12; }\n");
  EXPECT_EQ(r.lanes_at("STG"), 32U - 4);
}

TEST_F(WarpReplayerTest, CallsComeBack) {
  out_.assign(4096, 1.0F);
  in_.resize(32);
  std::iota(in_.begin(), in_.end(), 0);
  const ReplayedKernel r(
      "__attribute__((noinline)) float f(global float* out, int v) {\n"
      "  if (v < 5) { out[v] = native_sin(out[v]); return 3; }\n  return out[v] * 2; }\n"
      "kernel void k(global const int* in, global float* out) {\n"
      "  const int i = get_global_id(0);\n  float s = f(out, in[i]);\n"
      "  if (in[i] & 1) s += f(out, in[i] + 7);\n  out[i + 64] = s;\n}\n",
      "k", line_of(32, 32), {buffer_of(in_), buffer_of(out_)});
  r.expect_complete();
  EXPECT_EQ(r.lanes_at("CALL.REL"), 32U + 16);
  EXPECT_EQ(r.lanes_at("RET"), 32U + 16);
}

TEST_F(WarpReplayerTest, WarpsMayNotBeFull) {
  in_.resize(40);
  out_.resize(64);
  const ReplayedKernel r(
      "kernel void k(global const int* in, global float* out) { out[get_global_id(0)] = 1; }", "k",
      line_of(40, 40), {buffer_of(in_), buffer_of(out_)});
  r.expect_complete();
  EXPECT_EQ(r.warps_at("STG"), 2U);
  EXPECT_EQ(r.lanes_at("STG"), 40U);
  EXPECT_GT(r.replay().lane_slots_lost[r.replay().never_used()], 0U);
}

// Copies of a loop's body between tests: guards ask how many trips are left.
TEST_F(WarpReplayerTest, UnrolledLoops) {
  const ReplayedKernel r =
      replay("float s = 0; for (int k = 0; k < v; ++k) s += out[k * 32 + i];\nout[i] = s;\n", 0, 64);
  EXPECT_EQ(r.lanes_at("LDG"), 64U + 63 * 64 / 2);
  EXPECT_EQ(r.lanes_at("FADD"), 63U * 64 / 2);
}

TEST_F(WarpReplayerTest, UnrolledLoopsWithAStride) {
  const ReplayedKernel r =
      replay("float s = 0; for (int k = i; k < 1000; k += 32) s += out[k];\nout[i] = s;\n");
  EXPECT_EQ(r.nodes(Rule::unknown), 0U);
  // 1000 / 32 trips, and one more of the lanes below 1000 % 32.
  EXPECT_EQ(r.lanes_at("FADD"), 31U * 32 + 8);
}

TEST_F(WarpReplayerTest, UnrolledLoopsInALoop) {
  const ReplayedKernel r = replay(
      "float s = 1; for (int k = 0; k < 20; ++k) for (int j = 0; j < in[k]; ++j) s = s * 1.5F + j;\nout[i] = "
      "s;\n");
  EXPECT_EQ(r.lanes_at("FFMA"), 32U * (19 * 20 / 2));
}

// A guard that compares what is left with copies of a body lets through lanes that a later one would, too.
TEST_F(WarpReplayerTest, WaysThatTripsLeaveOpenAreCounted) {
  const ReplayedKernel open = replay(
      "int sum = 0; for (int row = 0; row < in[31]; ++row) { const int n = in[(7 * i + row) & 31] % 9;\n"
      "  for (int k = 0; k < n; ++k) { const int x = in[(row * 5 + k + i) & 31]; if (x & 2) sum += x; }\n"
      "  sum ^= row; }\nout[i] = sum;\n");
  EXPECT_GT(open.replay().trips_assumed, 0U);
  const ReplayedKernel rolled = replay("float x = v; while (x < 31) { x += 1; out[i + 32 * (int)x] = x; }\n");
  EXPECT_EQ(rolled.replay().trips_assumed, 0U);
}

TEST_F(WarpReplayerTest, BoundsThatAreKnownLeaveNoGuard) {
  const ReplayedKernel r =
      replay("float s = 0; for (int k = 0; k < 8; ++k) s += out[k * 32 + i];\nout[i] = s;\n");
  EXPECT_EQ(r.lanes_at("FADD"), 8U * 32);
}

TEST_F(WarpReplayerTest, LostSlotsAddUp) {
  const ReplayedKernel r = replay(
      "float x = v; while (x < 31) { x += 1; if (v & 1) out[i + 32 * (int)x] = native_sin(x); else out[i] = "
      "x; }\n");
  std::uint64_t idle = 0, lost = 0;
  for (std::uint32_t b = 0; b < r.kernel().code.blocks.size(); ++b) {
    const CodeBlock& block = r.kernel().code.blocks[b];
    const auto executions = r.replay().executions(b);
    for (std::size_t n = 0; n < executions.size(); ++n)
      idle += executions[n] * (32 - n) * (block.last - block.first);
  }
  for (const std::uint64_t of_branch : r.replay().lane_slots_lost) lost += of_branch;
  EXPECT_EQ(lost, idle);
}

TEST_F(WarpReplayerTest, OtherArchitectures) {
  for (const char* arch : {"sm_75", "sm_80", "sm_86", "sm_89"}) {
    SCOPED_TRACE(arch);
    in_.resize(32);
    std::iota(in_.begin(), in_.end(), 0);
    out_.assign(4096, 1.0F);
    const ReplayedKernel r(
        "kernel void k(global const int* in, global float* out) {\n"
        "  const int i = get_global_id(0);\n  float x = in[i];\n"
        "  while (x < 31) { x += 1; if (in[i] & 1) out[i + 32 * (int)x] = native_sin(x); }\n  out[i] = "
        "x;\n}\n",
        "k", line_of(32, 32), {buffer_of(in_), buffer_of(out_)}, arch);
    r.expect_complete();
    EXPECT_EQ(r.lanes_at("EXIT"), 32U);
  }
}

}  // namespace
}  // namespace warpgrain::profiler::sass
