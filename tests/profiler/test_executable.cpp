#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "profiler/executable.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

using testing::HasSubstr;

std::vector<BlockIndex> blocks_of(const LaneTrace& lane) {
  std::vector<BlockIndex> blocks;
  for (const BlockIndex* b = lane.blocks; *b != trace_end; ++b) blocks.push_back(*b);
  return blocks;
}

constexpr std::string_view half_half = R"(
kernel void half_half(global int* out) {
  int i = get_global_id(0);
  if (i & 1) {
    for (int k = 0; k < i; ++k) out[i] += out[k] * 3 + k;
  } else {
    out[i] = i * 7;
  }
}
)";

TEST(Executable, RunsAKernelInEveryTraceMode) {
  for (const TraceMode mode : {TraceMode::none, TraceMode::blocks, TraceMode::blocks_and_addresses}) {
    const auto executable = compile_kernel(half_half, "half_half", mode);
    std::vector<int> out(64, 1);
    run_launch(*executable, line_of(64, 32), {buffer_of(out)});
    std::vector<int> expected(64, 1);
    for (int i = 0; i < 64; ++i) {
      if (i & 1)
        for (int k = 0; k < i; ++k) expected[i] += expected[k] * 3 + k;
      else
        expected[i] = i * 7;
    }
    EXPECT_EQ(out, expected);
  }
}

// A lane's trace names recorded blocks only, and following it by the graph reaches a block without
// successors.
TEST(Executable, TracesAreWalksOfTheGraph) {
  const auto executable = compile_kernel(half_half, "half_half");
  const KernelGraph& graph = executable->graph();
  std::vector<int> out(32, 1);
  const auto runner = executable->runner(line_of(32, 32), std::vector{buffer_of(out)});
  const auto traces = runner->run({0, 0, 0});
  ASSERT_EQ(traces.size(), 32u);
  for (const LaneTrace& lane : traces) {
    const std::vector<BlockIndex> recorded = blocks_of(lane);
    ASSERT_FALSE(recorded.empty());
    EXPECT_EQ(recorded[0], 0);
    std::size_t next = 1;
    std::uint32_t block = 0;
    std::size_t accesses = 0;
    while (true) {
      accesses += graph.blocks[block].accesses.size();
      const auto& successors = graph.blocks[block].successors;
      if (successors.empty()) break;
      if (successors.size() > 1) {
        ASSERT_LT(next, recorded.size());
        ASSERT_THAT(successors, testing::Contains(recorded[next]));
        block = recorded[next++];
      } else {
        block = successors[0];
        if (graph.blocks[block].recorded) {
          ASSERT_LT(next, recorded.size());
          ASSERT_EQ(recorded[next++], block);
        }
      }
    }
    EXPECT_EQ(next, recorded.size());
    for (std::size_t a = 0; a < accesses; ++a) {
      const auto offset = lane.addresses[a] - reinterpret_cast<std::uint64_t>(out.data());
      EXPECT_LT(offset, out.size() * sizeof(int));
    }
  }
}

TEST(Executable, UnknownKernelListsTheNames) {
  EXPECT_THAT(refusal([] { compile_kernel(half_half, "half"); }),
              HasSubstr("unknown kernel 'half'; valid: half_half"));
}

}  // namespace
}  // namespace warpgrain::profiler
