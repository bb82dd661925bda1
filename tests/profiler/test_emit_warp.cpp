#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/profiler/warp_bench.hpp"

namespace warpgrain::profiler {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using u32 = std::uint32_t;

std::vector<u32> of_lanes(const std::function<u32(u32)>& value, u32 lanes = 32) {
  std::vector<u32> values(lanes);
  for (u32 lane = 0; lane < lanes; ++lane) values[lane] = value(lane);
  return values;
}

// The lane that a shuffle reads, as the PTX manual's pseudocode has it; -1 when it stays with its own.
int source_of(const std::string& mode, int lane, int b, int c) {
  const int mask = c >> 8 & 31, clamp = c & 31;
  const int last = (lane & mask) | (clamp & ~mask);
  const int first = lane & mask;
  const int j = mode == "up"     ? lane - b
                : mode == "down" ? lane + b
                : mode == "bfly" ? lane ^ b
                                 : first | (b & ~mask);
  const bool holds = mode == "up" ? j >= last : j <= last;
  return holds ? j : -1;
}

TEST(EmitWarp, ShufflesOfEveryModeAndSegment) {
  for (const std::string mode : {"up", "down", "bfly", "idx"})
    for (const int width : {32, 16, 8, 2})
      for (const int b : {0, 1, 3, 16, 31}) {
        const int c = (32 - width) << 8 | (mode == "up" ? 0 : 31);
        const auto got = run_warp_snippet(
            fmt::format("mad.lo.u32 %r1, %r0, 7, 100; shfl.sync.{}.b32 %r2|%p0, %r1, {}, {}, -1;"
                        "selp.u32 %r3, 1000, 0, %p0; add.u32 %r9, %r2, %r3;",
                        mode, b, c));
        EXPECT_EQ(
            got, of_lanes([&](u32 lane) {
              const int source = source_of(mode, static_cast<int>(lane), b, c);
              return static_cast<u32>(source >= 0 ? source * 7 + 1100 : static_cast<int>(lane) * 7 + 100);
            }))
            << mode << " width " << width << " b " << b;
      }
}

TEST(EmitWarp, ShufflesOfBitsAndWithOperandsThatVary) {
  // Lane i reads lane 31 - i; a float's bits go through unchanged.
  EXPECT_EQ(run_warp_snippet("sub.u32 %r1, 31, %r0; shfl.sync.idx.b32 %r9, %r0, %r1, 31, 0xffffffff;"),
            of_lanes([](u32 lane) { return 31 - lane; }));
}

TEST(EmitWarp, HalfAWarpShufflesBesideTheOther) {
  EXPECT_EQ(run_warp_snippet(R"(
    setp.lt.u32 %p0, %r0, 16; @%p0 bra LOW;
    shfl.sync.bfly.b32 %r9, %r0, 8, 31, 0xffff0000; bra STORE;
    LOW: shfl.sync.bfly.b32 %r9, %r0, 1, 31, 0xffff; add.u32 %r9, %r9, 100;)"),
            of_lanes([](u32 lane) { return lane < 16 ? (lane ^ 1) + 100 : lane ^ 8; }));
}

TEST(EmitWarp, TheSameShuffleAtTwoPlacesMeets) {
  EXPECT_EQ(run_warp_snippet(R"(
    setp.lt.u32 %p0, %r0, 16; @%p0 bra LOW;
    shfl.sync.bfly.b32 %r9, %r0, 16, 31, -1; bra STORE;
    LOW: shfl.sync.bfly.b32 %r9, %r0, 16, 31, -1;)"),
            of_lanes([](u32 lane) { return lane ^ 16; }));
}

TEST(EmitWarp, LanesThatHaveEndedAreNotWaitedFor) {
  EXPECT_EQ(run_warp_snippet(R"(
    setp.ge.u32 %p0, %r0, 20; @%p0 bra END;
    vote.sync.ballot.b32 %r9, 1, -1;)"),
            of_lanes([](u32 lane) { return lane < 20 ? 0xfffffu : 0; }));
}

TEST(EmitWarp, VotesOfEveryKind) {
  // Odd lanes vote yes, of the even half, of the odd half and of all.
  EXPECT_EQ(run_warp_snippet(R"(
    and.b32 %r1, %r0, 1; setp.ne.u32 %p0, %r1, 0;
    vote.sync.ballot.b32 %r9, %p0, -1;)"),
            of_lanes([](u32) { return 0xaaaaaaaau; }));
  const auto bits = [](const std::string& predicate) {
    return run_warp_snippet(fmt::format(R"(
      setp.{}; vote.sync.all.pred %p1, %p0, -1; selp.u32 %r1, 1, 0, %p1;
      vote.sync.any.pred %p1, %p0, -1; selp.u32 %r2, 2, 0, %p1;
      vote.sync.uni.pred %p1, !%p0, -1; selp.u32 %r3, 4, 0, %p1;
      or.b32 %r9, %r1, %r2; or.b32 %r9, %r9, %r3;)",
                                        predicate))[13];
  };
  EXPECT_EQ(bits("lt.u32 %p0, %r0, 32"), 7u);
  EXPECT_EQ(bits("lt.u32 %p0, %r0, 5"), 2u);
  EXPECT_EQ(bits("lt.u32 %p0, %r0, 0"), 4u);
}

TEST(EmitWarp, MatchesOfEqualValues) {
  EXPECT_EQ(run_warp_snippet("shr.u32 %r1, %r0, 3; match.any.sync.b32 %r9, %r1, -1;"),
            of_lanes([](u32 lane) { return 0xffu << (lane / 8 * 8); }));
  // The high words differ, the low ones do not.
  EXPECT_EQ(run_warp_snippet("and.b32 %r1, %r0, 3; mov.b64 %d1, {0, %r1}; match.any.sync.b64 %r9, %d1, -1;"),
            of_lanes([](u32 lane) { return 0x11111111u << (lane & 3); }));
  const std::string all = "match.all.sync.b32 %r1|%p0, %r2, -1; selp.u32 %r9, %r1, 7, %p0;";
  EXPECT_EQ(run_warp_snippet("mov.u32 %r2, 9;" + all), of_lanes([](u32) { return ~0u; }));
  EXPECT_EQ(run_warp_snippet("mov.u32 %r2, %r0;" + all), of_lanes([](u32) { return 7u; }));
}

TEST(EmitWarp, ReductionsOfEveryKind) {
  const auto reduced = [](const std::string& operation) {
    return run_warp_snippet(fmt::format("sub.u32 %r1, %r0, 16; redux.sync.{} %r9, %r1, -1;", operation))[7];
  };
  EXPECT_EQ(reduced("add.s32"), static_cast<u32>(-16));
  EXPECT_EQ(reduced("min.s32"), static_cast<u32>(-16));
  EXPECT_EQ(reduced("max.s32"), 15u);
  EXPECT_EQ(reduced("min.u32"), 0u);
  EXPECT_EQ(reduced("max.u32"), ~0u);
  EXPECT_EQ(reduced("and.b32"), 0u);
  EXPECT_EQ(reduced("or.b32"), ~0u);
  EXPECT_EQ(reduced("xor.b32"), 0u);
}

TEST(EmitWarp, OneIsElected) {
  EXPECT_EQ(run_warp_snippet(R"(
    setp.lt.u32 %p0, %r0, 4; @%p0 bra STORE;
    elect.sync %r1|%p1, 0xfffffff0; selp.u32 %r2, 100, 0, %p1; add.u32 %r9, %r1, %r2;)"),
            of_lanes([](u32 lane) { return lane < 4    ? 0u
                                           : lane == 4 ? 104u
                                                       : 4u; }));
}

// Lane i goes through the loop i % 4 + 1 times; those in it are the active ones.
TEST(EmitWarp, ActiveLanesOfALoop) {
  EXPECT_EQ(run_warp_snippet(R"(
    and.b32 %r1, %r0, 3; mov.u32 %r2, 0;
    LOOP: activemask.b32 %r3; popc.b32 %r4, %r3; mad.lo.u32 %r9, %r9, 100, %r4;
    add.u32 %r2, %r2, 1; setp.le.u32 %p0, %r2, %r1; @%p0 bra LOOP;
    activemask.b32 %r3; setp.ne.u32 %p1, %r3, -1; @%p1 mov.u32 %r9, 0;)"),
            of_lanes([](u32 lane) {
              const u32 of_trips[] = {32, 3224, 322416, 32241608};
              return of_trips[lane & 3];
            }));
}

TEST(EmitWarp, ActiveLanesOfTheSidesOfABranch) {
  EXPECT_EQ(run_warp_snippet(R"(
    setp.lt.u32 %p0, %r0, 5; @%p0 bra LOW;
    activemask.b32 %r9; bra STORE;
    LOW: activemask.b32 %r9;)"),
            of_lanes([](u32 lane) { return lane < 5 ? 0x1fu : 0xffffffe0u; }));
}

TEST(EmitWarp, FormsOlderThanVoltaTakeThoseThatAreThere) {
  EXPECT_EQ(run_warp_snippet("setp.lt.u32 %p0, %r0, 9; @%p0 bra STORE; vote.ballot.b32 %r9, 1;"),
            of_lanes([](u32 lane) { return lane < 9 ? 0u : ~0x1ffu; }));
  EXPECT_EQ(run_warp_snippet("shfl.up.b32 %r9, %r0, 1, 0;"),
            of_lanes([](u32 lane) { return lane == 0 ? 0 : lane - 1; }));
}

TEST(EmitWarp, WarpsOfAGroupMeetAlone) {
  EXPECT_EQ(run_warp_snippet("shfl.sync.bfly.b32 %r9, %r0, 31, 31, -1;", 80),
            of_lanes([](u32 lane) { return lane < 64          ? lane ^ 31
                                           : (lane ^ 31) < 80 ? lane ^ 31
                                                              : 0; }, 80));
  EXPECT_EQ(run_warp_snippet("vote.sync.ballot.b32 %r9, 1, -1;", 40)[39], 0xffu);
}

TEST(EmitWarp, AWarpBarrierOrdersWhatItsLanesDo) {
  EXPECT_EQ(run_warp_snippet(R"(
    mul.wide.u32 %d1, %r0, 4; mov.u64 %d2, scratch; add.s64 %d1, %d1, %d2;
    st.shared.u32 [%d1], %r0; bar.warp.sync -1;
    xor.b32 %r1, %r0, 21; mul.wide.u32 %d1, %r1, 4; add.s64 %d1, %d1, %d2; ld.shared.u32 %r9, [%d1];)"),
            of_lanes([](u32 lane) { return lane ^ 21; }));
}

TEST(EmitWarp, PredicatedOperationsAreThoseOfLanesThatRunThem) {
  EXPECT_EQ(run_warp_snippet("setp.lt.u32 %p0, %r0, 6; @%p0 activemask.b32 %r9;"),
            of_lanes([](u32 lane) { return lane < 6 ? 0x3fu : 0; }));
}

TEST(EmitWarp, DeadlocksAreNamed) {
  EXPECT_THAT(
      refused_warp_snippet(R"(
    setp.lt.u32 %p0, %r0, 12; @%p0 bra LOW;
    shfl.sync.bfly.b32 %r9, %r0, 16, 31, -1; bra STORE;
    LOW: vote.sync.ballot.b32 %r9, 1, -1;)"),
      AllOf(HasSubstr(
                "barrier_divergence: deadlock between lanes: 20 wait for lanes of their warp at PTX line 10"),
            HasSubstr("12 wait for lanes of their warp at PTX line 11")));
  EXPECT_THAT(refused_warp_snippet(R"(
    setp.lt.u32 %p0, %r0, 12; @%p0 bra LOW;
    bar.sync 0; bra STORE;
    LOW: vote.sync.ballot.b32 %r9, 1, -1;)"),
              HasSubstr("20 work-items wait at the barrier at PTX line 10"));
  EXPECT_THAT(
      refused_warp_snippet("vote.sync.ballot.b32 %r9, 1, 0xffff;"),
      HasSubstr("work-item 16: member mask 0xffff at PTX line 8; expected a mask with the lane's own bit, "
                "0x10000"));
}

TEST(EmitWarp, RefusesFormsThatPtxDoesNotHave) {
  for (const std::string code :
       {"shfl.sync.b32 %r9, %r0, 1, 31, -1;", "shfl.sync.up.b64 %d1, %d2, 1, 31, -1;",
        "vote.sync.ballot.pred %p0, %p1, -1;", "vote.sync.all.b32 %r9, %p1, -1;",
        "match.any.b32 %r9, %r0, -1;", "redux.add.s32 %r9, %r0, -1;", "redux.sync.add.s64 %d1, %d2, -1;",
        "elect.b32 %r9, -1;"})
    EXPECT_THAT(refused_warp_snippet(code), HasSubstr("is not carried")) << code;
}

}  // namespace
}  // namespace warpgrain::profiler
