#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/profiler/warp_bench.hpp"

namespace warpgrain::profiler {
namespace {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;
using u32 = std::uint32_t;

// Puts %r0 into a word of shared memory each, and reads that of lane %r1 behind `barrier`.
std::string handed_over(const std::string& barrier) {
  return fmt::format(R"(
    mov.u64 %d2, scratch; mul.wide.u32 %d1, %r0, 4; add.s64 %d1, %d1, %d2; st.shared.u32 [%d1], %r0;
    {}
    mul.wide.u32 %d1, %r1, 4; add.s64 %d1, %d1, %d2; ld.shared.u32 %r9, [%d1];)",
                     barrier);
}

TEST(EmitBarrier, EveryFormOfTheWholeGroup) {
  for (const std::string form :
       {"bar.sync 0;", "bar.cta.sync 3;", "barrier.sync 1;", "barrier.cta.sync.aligned 15;",
        "bar.sync 2, 128;", "mov.u32 %r2, 5; mov.u32 %r3, 128; barrier.sync %r2, %r3;"}) {
    const auto got = run_warp_snippet("sub.u32 %r1, 127, %r0;" + handed_over(form), 128);
    for (u32 i = 0; i < 128; ++i) EXPECT_EQ(got[i], 127 - i) << form;
  }
}

// Two pairs of warps, each at a barrier of its own.
TEST(EmitBarrier, NamedBarriersOfSomeWarps) {
  const auto got = run_warp_snippet(
      "xor.b32 %r1, %r0, 32; shr.u32 %r2, %r0, 6; add.u32 %r2, %r2, 1;" + handed_over("bar.sync %r2, 64;"),
      128);
  for (u32 i = 0; i < 128; ++i) EXPECT_EQ(got[i], i ^ 32);
}

// Warp 0 produces and goes on, warps 1 and 2 wait for it.
TEST(EmitBarrier, ArrivalsDoNotWait) {
  const auto got = run_warp_snippet(R"(
    mov.u64 %d2, scratch; mul.wide.u32 %d1, %r0, 4; add.s64 %d1, %d1, %d2;
    setp.ge.u32 %p0, %r0, 32; @%p0 bra CONSUME;
    st.shared.u32 [%d1], %r0; bar.arrive 1, 96; mov.u32 %r9, 7; bra STORE;
    CONSUME: bar.sync 1, 96; and.b32 %r1, %r0, 31; mul.wide.u32 %d1, %r1, 4; add.s64 %d1, %d1, %d2;
    ld.shared.u32 %r9, [%d1];)",
                                    96);
  for (u32 i = 0; i < 96; ++i) EXPECT_EQ(got[i], i < 32 ? 7 : i & 31);
}

TEST(EmitBarrier, Reductions) {
  EXPECT_THAT(run_warp_snippet("setp.lt.u32 %p0, %r0, 37; bar.red.popc.u32 %r9, 0, %p0;", 100), Each(37u));
  EXPECT_THAT(
      run_warp_snippet("setp.lt.u32 %p0, %r0, 37; barrier.red.popc.aligned.u32 %r9, 1, 64, !%p0;", 64),
      Each(27u));
  const auto reduced = [](const std::string& operation, u32 bound) {
    return run_warp_snippet(
        fmt::format("setp.lt.u32 %p0, %r0, {}; bar.red.{}.pred %p1, 0, %p0; selp.u32 %r9, 1, 2, "
                    "%p1;",
                    bound, operation),
        64);
  };
  EXPECT_THAT(reduced("and", 64), Each(1u));
  EXPECT_THAT(reduced("and", 63), Each(2u));
  EXPECT_THAT(reduced("or", 1), Each(1u));
  EXPECT_THAT(reduced("or", 0), Each(2u));
}

// CUDA's rule: threads that have ended do not hold the others up.
TEST(EmitBarrier, LanesThatHaveEndedAreNotWaitedFor) {
  const auto got = run_warp_snippet(
      "setp.ge.u32 %p0, %r0, 70; @%p0 bra END; xor.b32 %r1, %r0, 1;" + handed_over("bar.sync 0;"), 96);
  for (u32 i = 0; i < 70; ++i) EXPECT_EQ(got[i], i ^ 1);
}

// Whole warps may come from different places; a barrier with a predicate is one of the lanes that run it.
TEST(EmitBarrier, WarpsMeetFromDifferentPlaces) {
  const auto got = run_warp_snippet(
      "xor.b32 %r1, %r0, 32; setp.lt.u32 %p0, %r0, 32;" + handed_over("@%p0 bar.sync 0; @!%p0 bar.sync 0;"),
      64);
  for (u32 i = 0; i < 64; ++i) EXPECT_EQ(got[i], i ^ 32);
}

TEST(EmitBarrier, WhatCannotEndIsNamed) {
  const std::string halves = R"(setp.lt.u32 %p0, %r0, 16; @%p0 bra LOW;
    {0}; bra STORE;
    LOW: {0};)";
  EXPECT_THAT(refused_warp_snippet(fmt::format(fmt::runtime(halves), "bar.sync 0"), 64),
              AllOf(HasSubstr("barrier_divergence: 48 work-items wait at PTX line 9"),
                    HasSubstr("16 work-items wait at PTX line 10")));
  EXPECT_EQ(refused_warp_snippet(fmt::format(fmt::runtime(halves), "barrier.sync 0"), 64), "");
  EXPECT_THAT(refused_warp_snippet("bar.sync 1, 96;", 64), HasSubstr("64 work-items wait at PTX line 8"));
  EXPECT_THAT(refused_warp_snippet("bar.sync 16;"), HasSubstr("a barrier's number above 15 at PTX line 8"));
  EXPECT_THAT(refused_warp_snippet("bar.sync 1, 40;"), HasSubstr("no multiple of 32 at PTX line 8"));
  EXPECT_THAT(refused_warp_snippet("and.b32 %r1, %r0, 32; add.u32 %r1, %r1, 32; bar.sync 1, %r1;", 64),
              HasSubstr("work-item 32: a thread count other than that of those who wait"));
  EXPECT_THAT(refused_warp_snippet("bar.arrive 1, 64; bar.arrive 1, 64;", 64),
              HasSubstr("a second arrival before the barrier is complete"));
  EXPECT_THAT(refused_warp_snippet("bar.arrive 1;"), HasSubstr("expected a thread count"));
  EXPECT_THAT(refused_warp_snippet("bar.red.u32 %r9, 1, %p0;"), HasSubstr("expected .popc, .and or .or"));
}

}  // namespace
}  // namespace warpgrain::profiler
