#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <thread>

#include "profiler/work_group.hpp"
#include "tests/profiler/ptx_text.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refused_run(std::string_view source, const LaunchShape& shape,
                        TraceMode mode = TraceMode::blocks_and_addresses) {
  const auto executable = compile_kernel(source, "k", mode);
  std::vector<int> out(4096);
  const std::vector<KernelArgument> arguments{buffer_of(out)};
  return refusal([&] { run_launch(*executable, shape, arguments); });
}

TEST(WorkGroup, LanesThatEndBeforeABarrierDiverge) {
  const std::string message = refused_run(R"(kernel void k(global int* out) {
  if (get_local_id(0) >= 24) return;
  barrier(CLK_LOCAL_MEM_FENCE);
  out[get_global_id(0)] = 1;
})",
                                          line_of(64, 32));
  EXPECT_THAT(message, HasSubstr("kernel 'k': kernel.cl:3 (PTX line "));
  EXPECT_THAT(message, HasSubstr("barrier_divergence: 24 work-items wait at kernel.cl:3 (PTX line "));
  EXPECT_THAT(message, HasSubstr(", 8 have ended, work-item (0, 0, 0) in work-group (0, 0, 0)"));
}

TEST(WorkGroup, LanesAtDifferentBarriersDiverge) {
  const std::string message = refused_run(R"(kernel void k(global int* out) {
  int i = get_local_id(0);
  if (i & 1) {
    for (int n = 0; n < i; ++n) {
      barrier(CLK_LOCAL_MEM_FENCE);
      out[i] += out[i ^ 1];
    }
  } else {
    barrier(CLK_LOCAL_MEM_FENCE);
    out[i] = 4;
  }
})",
                                          line_of(32, 32));
  EXPECT_THAT(message, HasSubstr("16 work-items wait at kernel.cl:9"));
  EXPECT_THAT(message, HasSubstr("16 work-items wait at kernel.cl:5"));
}

TEST(WorkGroup, EndlessLoopsEndWithAnError) {
  const std::string source = R"(kernel void k(global int* out) {
  volatile global int* flag = out;
  while (flag[1] == 0) flag[0] += 2;
})";
  for (const TraceMode mode : {TraceMode::blocks, TraceMode::blocks_and_addresses})
    EXPECT_THAT(refused_run(source, line_of(2, 1), mode),
                AllOf(HasSubstr("kernel 'k': kernel.cl:3 (PTX line "),
                      HasSubstr("it was stopped and is not counted, work-item (0, 0, 0) in work-group")));
  // Without a branch nothing is recorded; such a loop is known by its form.
  const auto executable = Executable::compile(
      ptx_module(".entry k() { .reg .b32 %r<2>; $L1: add.u32 %r0, %r0, 1; bra $L2; $L2: bra.uni $L1; }"), "k",
      TraceMode::none, "k.ptx");
  EXPECT_THAT(refusal([&] { run_launch(*executable, line_of(1, 1), {}); }),
              HasSubstr("PTX line 4: endless_loop: it entered a loop that nothing leaves"));
}

TEST(WorkGroup, EndlessLoopsWithBarriersToo) {
  EXPECT_THAT(refused_run(R"(kernel void k(global int* out) {
  barrier(CLK_LOCAL_MEM_FENCE);
  volatile global int* flag = out;
  while (flag[1] == 0) flag[0] += 2;
})",
                          line_of(64, 64)),
              HasSubstr("it was stopped"));
}

TEST(WorkGroup, ATrapEndsTheLaunch) {
  const auto executable =
      Executable::compile(ptx_module(".entry k() { .reg .b32 %r<1>; .reg .pred %p<1>; mov.u32 %r0, %tid.x; "
                                     "setp.eq.u32 %p0, %r0, 3;\n@%p0 trap; ret; }"),
                          "k", TraceMode::blocks, "k.ptx");
  run_launch(*executable, line_of(3, 3), {});
  EXPECT_THAT(refusal([&] { run_launch(*executable, line_of(4, 4), {}); }),
              HasSubstr("PTX line 5: trap: it ran the trap, work-item (3, 0, 0)"));
}

TEST(WorkGroup, LocalMemoryIsZeroInEveryGroup) {
  const auto executable =
      compile_kernel(R"(kernel void k(global int* out, local int* first, local char* second) {
  local int own[4];
  int l = get_local_id(0);
  out[get_global_id(0)] = first[l] + own[l] + second[l];
  barrier(CLK_LOCAL_MEM_FENCE);
  first[l] = 1; own[l] = 2; second[l] = 3;
  barrier(CLK_LOCAL_MEM_FENCE);
  out[get_global_id(0)] += first[l ^ 1] * 100 + own[l ^ 1] * 10 + second[l ^ 1];
})",
                     "k");
  EXPECT_EQ(executable->graph().shared_bytes, 16u);
  EXPECT_TRUE(executable->graph().has_barrier);
  std::vector<int> out(64);
  run_launch(*executable, line_of(64, 4),
             {buffer_of(out), KernelArgument::local(16), KernelArgument::local(4)});
  EXPECT_EQ(out, std::vector<int>(64, 123));
}

TEST(WorkGroup, RunnersOfOneExecutableOnSeveralThreads) {
  const auto executable = compile_kernel(R"(kernel void k(global uint* out, local uint* place) {
  uint l = get_local_id(0), x = get_global_id(0);
  for (uint n = 0; n < 200 + x % 50; ++n) x = x * 1664525u + 1013904223u;
  place[l] = x;
  barrier(CLK_LOCAL_MEM_FENCE);
  out[get_global_id(0)] = place[get_local_size(0) - 1 - l];
})",
                                         "k");
  const LaunchShape shape = line_of(4096, 64);
  std::vector<std::uint32_t> expected(4096), out(4096);
  run_launch(*executable, shape, {buffer_of(expected), KernelArgument::local(256)});
  const std::vector<KernelArgument> arguments{buffer_of(out), KernelArgument::local(256)};
  std::vector<std::thread> threads;
  for (std::uint64_t t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      const auto runner = executable->runner(shape, arguments);
      for (std::uint64_t g = t; g < 64; g += 4) runner->run({g, 0, 0});
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(out, expected);
}

}  // namespace
}  // namespace warpgrain::profiler
