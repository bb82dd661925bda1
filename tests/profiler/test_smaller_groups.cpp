// Launches whose last work-groups are smaller (OpenCL 2.0, section 3.2.1), in one to three dimensions: what
// each work-item is told of the index space, its barrier, and how it stands in a warp.

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "core/error.hpp"
#include "profiler/opencl_frontend.hpp"
#include "profiler/profile.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

// What every work-item writes, OpenCL's own names for it.
constexpr const char* describing = R"(
kernel void describe(global uint* told) {
  const size_t w = get_global_size(0), h = get_global_size(1);
  const size_t at = (get_global_id(2) * h + get_global_id(1)) * w + get_global_id(0);
  for (uint d = 0; d < 3; ++d) {
    told[at * 18 + d * 6] = get_global_size(d);
    told[at * 18 + d * 6 + 1] = get_local_size(d);
    told[at * 18 + d * 6 + 2] = get_enqueued_local_size(d);
    told[at * 18 + d * 6 + 3] = get_num_groups(d);
    told[at * 18 + d * 6 + 4] = get_group_id(d);
    told[at * 18 + d * 6 + 5] = get_local_id(d);
  }
})";

TEST(SmallerGroups, AreToldOfTheIndexSpace) {
  const auto executable =
      compile_kernel(describing, "describe", TraceMode::blocks, std::string(smaller_groups_option));
  for (const LaunchShape& shape : {LaunchShape{{70, 1, 1}, {32, 1, 1}}, LaunchShape{{5, 1, 1}, {64, 1, 1}},
                                   LaunchShape{{10, 7, 5}, {4, 3, 2}}, LaunchShape{{64, 3, 1}, {32, 2, 1}},
                                   LaunchShape{{64, 1, 1}, {32, 1, 1}}}) {
    const std::uint64_t items = shape.global_size[0] * shape.global_size[1] * shape.global_size[2];
    std::vector<std::uint32_t> told(items * 18, 0xFFFFFFFFU);
    run_launch(*executable, shape, {buffer_of(told)});
    for (std::uint64_t item = 0; item < items; ++item) {
      const std::uint64_t id[3] = {item % shape.global_size[0],
                                   item / shape.global_size[0] % shape.global_size[1],
                                   item / shape.global_size[0] / shape.global_size[1]};
      for (std::size_t d = 0; d < 3; ++d) {
        const std::uint64_t local = shape.local_size[d], global = shape.global_size[d], group = id[d] / local;
        const std::vector<std::uint64_t> expected{global, std::min(local, global - group * local),
                                                  local,  (global + local - 1) / local,
                                                  group,  id[d] % local};
        for (std::size_t k = 0; k < 6; ++k)
          ASSERT_EQ(told[item * 18 + d * 6 + k], expected[k])
              << "item " << item << " dimension " << d << " function " << k;
      }
    }
  }
}

TEST(SmallerGroups, MeetAtTheirBarriers) {
  const auto executable = compile_kernel(R"(
kernel void reverse(global int* data) {
  local int copy[32];
  const size_t i = get_local_id(0), n = get_local_size(0);
  copy[i] = data[get_global_id(0)];
  barrier(CLK_LOCAL_MEM_FENCE);
  data[get_global_id(0)] = copy[n - 1 - i];
})",
                                         "reverse", TraceMode::blocks, std::string(smaller_groups_option));
  std::vector<int> data(75), expected(75);
  for (int i = 0; i < 75; ++i) {
    data[i] = i;
    const int begin = i / 32 * 32, end = std::min(begin + 32, 75);
    expected[i] = begin + end - 1 - i;
  }
  run_launch(*executable, {{75, 1, 1}, {32, 1, 1}}, {buffer_of(data)});
  EXPECT_EQ(data, expected);
}

// Of 10 x 3 work-items in groups of 8 x 2: warps of 16, 2 x 2, 8 and 2 work-items, packed as they are.
TEST(SmallerGroups, AreWarpsOfTheirOwnLanes) {
  const auto executable =
      compile_kernel("kernel void one(global int* a) { a[get_global_id(1) * 10 + get_global_id(0)] = 1; }",
                     "one", TraceMode::blocks, std::string(smaller_groups_option));
  std::vector<int> a(30);
  const std::vector<KernelArgument> arguments{buffer_of(a)};
  const LaunchCounters counters =
      profile_launch(*executable, {{10, 3, 1}, {8, 2, 1}}, arguments, "", {.warp_width = 8, .threads = 1});
  EXPECT_EQ(std::count(a.begin(), a.end(), 1), 30);
  const Totals& totals = counters.totals;
  const std::uint64_t instructions = totals.thread_instructions / 30;
  EXPECT_EQ(totals.thread_instructions, 30 * instructions);
  // Widths of 8: two warps of 8, one of 4, one of 8, one of 2.
  EXPECT_EQ(totals.warp_instructions, 5 * instructions);
}

TEST(SmallerGroups, AreRefusedWhereNobodyAskedForThem) {
  const auto executable = compile_kernel(describing, "describe", TraceMode::blocks, "-cl-std=CL2.0");
  std::vector<std::uint32_t> told(70 * 18);
  try {
    run_launch(*executable, {{70, 1, 1}, {32, 1, 1}}, {buffer_of(told)});
    FAIL() << "nothing was refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("global size 70 and local size 32 in dimension 0"));
  }
}

}  // namespace
}  // namespace warpgrain::profiler
