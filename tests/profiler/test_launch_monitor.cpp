// What stops work-items: budgets, traces, traps, barriers that part, loops that wait for others.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/profiler/checked_launch.hpp"
#include "tests/profiler/ptx_text.hpp"

namespace warpgrain::profiler {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

LaunchCounters run_on_ints(std::string_view source, const LaunchShape& shape, unsigned threads = 1,
                           TraceMode mode = TraceMode::blocks_and_addresses) {
  std::vector<int> a(1024);
  return run_checked(source, shape, {buffer_of(a)}, threads, mode);
}

TEST(LaunchMonitor, BudgetsEndLoops) {
  const std::string source = R"(kernel void k(global int* a) {
  int i = get_global_id(0), n = 0;
  if (i == 5)
    while (a[512 + (n & 511)] == 0) n += 3;
  a[i] = n;
})";
  for (const TraceMode mode : {TraceMode::blocks, TraceMode::blocks_and_addresses}) {
    const auto counters = run_on_ints(source, line_of(64, 32), 1, mode);
    EXPECT_THAT(findings(counters),
                ElementsAre(AllOf(HasSubstr("kernel.cl:4: "), HasSubstr("work-item (5, 0, 0)"))));
    EXPECT_EQ(counters.warps, 2u);
    EXPECT_FALSE(counters.given_up);
  }
}

TEST(LaunchMonitor, BudgetsWithoutTraces) {
  const auto executable =
      Executable::compile(ptx_module(R"(.entry k(.param .u64 out) { .reg .b32 %r<2>; .reg .pred %p<1>;
mov.u32 %r0, 0;
$L: add.u32 %r0, %r0, 2; setp.ne.u32 %p0, %r0, 1; @%p0 bra $L; ret; })"),
                          "k", TraceMode::none, "k.ptx");
  std::vector<int> a(4);
  const std::vector<KernelArgument> arguments{buffer_of(a)};
  const auto monitor = executable->monitor(line_of(1, 1), arguments, {.max_instructions = 10'000});
  executable->runner(*monitor)->run({0, 0, 0});
  ASSERT_EQ(monitor->diagnostics().size(), 1u);
  EXPECT_EQ(monitor->diagnostics()[0].kind, DiagnosticKind::instruction_limit);
  EXPECT_EQ(monitor->diagnostics()[0].place.ptx_line, 6u);
}

TEST(LaunchMonitor, ManyStoppedWorkItemsEndTheLaunch) {
  const auto counters = run_on_ints(R"(kernel void k(global int* a) {
  while (a[1] == 0) a[0] += 2;
})",
                                    line_of(1 << 16, 64), 2);
  EXPECT_TRUE(counters.given_up);
  ASSERT_FALSE(counters.diagnostics.empty());
  const Diagnostic& stopped = counters.diagnostics.front();
  EXPECT_THAT(findings(counters).front(), Not(HasSubstr("waits for memory")));
  EXPECT_LT(stopped.count, 20000u);
}

TEST(LaunchMonitor, SpinLocksAreNamed) {
  const auto counters = run_on_ints(R"(kernel void k(global int* a) {
  if (get_global_id(0) == 0) {
    while (atomic_cmpxchg(a, 1, 2) != 1) {}
  } else {
    atomic_xchg(a, 1);
  }
})",
                                    line_of(64, 64));
  EXPECT_THAT(
      findings(counters),
      ElementsAre(AllOf(HasSubstr("kernel.cl:3: "),
                        HasSubstr("the loop waits for memory that another work-item would have to write; "
                                  "lanes run one after another"),
                        HasSubstr("work-item (0, 0, 0)"))));
  EXPECT_EQ(counters.warps, 2u);
}

TEST(LaunchMonitor, LoopsOfBarriersEnd) {
  const auto counters = run_on_ints(R"(kernel void k(global int* a) {
  while (a[1000] == 0) barrier(CLK_GLOBAL_MEM_FENCE);
})",
                                    line_of(64, 64));
  EXPECT_TRUE(counters.given_up);
  EXPECT_THAT(findings(counters), Not(IsEmpty()));
}

TEST(LaunchMonitor, ThoseThatPartAtABarrierGoOn) {
  std::vector<int> a(64);
  const auto counters = run_checked(R"(kernel void k(global int* a) {
  int l = get_local_id(0);
  if (l >= 24) return;
  barrier(CLK_LOCAL_MEM_FENCE);
  a[get_global_id(0)] = 1;
})",
                                    line_of(64, 32), {buffer_of(a)});
  EXPECT_THAT(findings(counters),
              ElementsAre("kernel.cl:4: barrier_divergence: 24 work-items wait at kernel.cl:4, 8 have ended, "
                          "work-item (0, 0, 0) in work-group (0, 0, 0); 2 times"));
  EXPECT_EQ(a[23], 1);
  EXPECT_EQ(a[55], 1);
  EXPECT_EQ(counters.warps, 2u);
}

TEST(LaunchMonitor, TrapsEndTheirWorkItem) {
  const auto executable =
      Executable::compile(ptx_module(".entry k() { .reg .b32 %r<1>; .reg .pred %p<1>; mov.u32 %r0, %tid.x; "
                                     "setp.eq.u32 %p0, %r0, 3;\n@%p0 trap; ret; }"),
                          "k", TraceMode::blocks, "k.ptx", Checks::on);
  const auto counters = run_checked(*executable, line_of(64, 32), {});
  EXPECT_THAT(
      findings(counters),
      ElementsAre("PTX line 5: trap: it ran the trap, work-item (3, 0, 0) in work-group (0, 0, 0); 2 times"));
  EXPECT_EQ(counters.totals.thread_instructions, 64u * 3 + 62);
}

TEST(LaunchMonitor, TwoFindingsInOneKernelAndUnchecked) {
  const std::string source = R"(kernel void k(global int* a) {
  int i = get_global_id(0);
  if (i == 3) a[1024] = 1;
  a[0] = i;
})";
  EXPECT_THAT(findings(run_on_ints(source, line_of(64, 32))),
              ElementsAre(HasSubstr("kernel.cl:3: out_of_bounds"), HasSubstr("kernel.cl:4: data_race")));
  const auto executable =
      Executable::compile(compile_opencl(source, "kernel.cl", "").ptx, "k", TraceMode::blocks, "kernel.cl");
  std::vector<int> a(1025);
  EXPECT_THAT(findings(run_checked(*executable, line_of(64, 32), {buffer_of(a)})), IsEmpty());
}

TEST(LaunchMonitor, HugePrivateMemoryIsRefused) {
  const std::string message = refusal([] {
    Executable::compile(
        ptx_module(".entry k() { .local .align 4 .b8 big[1000000]; .reg .b64 %d<1>; mov.u64 %d0, "
                   "big; ret; }"),
        "k", TraceMode::blocks, "k.ptx");
  });
  EXPECT_THAT(message, HasSubstr("1000000 bytes of local memory a work-item; expected at most 524288"));
  const auto counters = run_on_ints(R"(kernel void k(global int* a) {
  int big[50000];
  int n = get_local_id(0) * 17;
  for (int i = 0; i < 64; ++i) big[(n + i * 781) % 50000] = i;
  barrier(CLK_LOCAL_MEM_FENCE);
  a[get_global_id(0)] = big[(n + 781) % 50000];
})",
                                    line_of(128, 64));
  EXPECT_THAT(findings(counters), IsEmpty());
}

}  // namespace
}  // namespace warpgrain::profiler
