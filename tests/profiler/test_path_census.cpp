#include <algorithm>
#include <gtest/gtest.h>

#include "profiler/observers/path_census.hpp"
#include "profiler/profile.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

std::vector<LoopPaths> census_of(const char* source, std::uint64_t items,
                                 const std::vector<KernelArgument>& arguments, int launches = 1) {
  const auto executable = compile_kernel(source, "k", TraceMode::blocks);
  PathCensus census;
  ProfileOptions options;
  options.observer = &census;
  for (int k = 0; k < launches; ++k)
    profile_launch(*executable, line_of(items, 32), arguments, source, options);
  return census.bodies();
}

// Each lane goes round its own number of times, and takes one of three ways each time: the two stores make
// every way a branch that no select replaces.
constexpr const char* three_ways = R"(
kernel void k(global int* a, global volatile int* out) {
  const int i = get_global_id(0);
  for (int trip = 0; trip < a[i]; ++trip) {
    const int what = a[trip + i] % 3;
    if (what == 0) out[0] = trip;
    else if (what == 1) out[1] = trip;
  }
})";

TEST(PathCensus, CountsPassesAndDifferentPathsOfALoop) {
  std::vector<int> a(64 + 16);
  std::uint64_t trips = 0;
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = static_cast<int>(i * 7 % 11);
  for (std::size_t i = 0; i < 64; ++i) trips += static_cast<std::uint64_t>(a[i]);
  std::vector<int> out(2);
  for (const int launches : {1, 2}) {
    const auto bodies = census_of(three_ways, 64, {buffer_of(a), buffer_of(out)}, launches);
    const auto loop = std::ranges::find(bodies, true, &LoopPaths::is_loop);
    ASSERT_NE(loop, bodies.end());
    EXPECT_EQ(loop->kernel, "k");
    EXPECT_EQ(loop->passes, trips * static_cast<std::uint64_t>(launches));
    // Three ways in the middle of the loop, and the same ways for the last pass.
    EXPECT_GE(loop->paths, 3U);
    EXPECT_LE(loop->paths, 6U);
    EXPECT_GE(loop->branches, 2U);
    const auto outside = std::ranges::find(bodies, false, &LoopPaths::is_loop);
    ASSERT_NE(outside, bodies.end());
    EXPECT_EQ(outside->passes, 64U * static_cast<std::uint64_t>(launches));
  }
}

TEST(PathCensus, WithoutBranchesThereIsOnePath) {
  std::vector<int> a(64);
  const auto bodies =
      census_of("kernel void k(global int* a) { a[get_global_id(0)] = 1; }", 64, {buffer_of(a)});
  ASSERT_EQ(bodies.size(), 1U);
  EXPECT_FALSE(bodies[0].is_loop);
  EXPECT_EQ(bodies[0].branches, 0U);
  EXPECT_EQ(bodies[0].paths, 1U);
  EXPECT_EQ(bodies[0].passes, 64U);
}

}  // namespace
}  // namespace warpgrain::profiler
