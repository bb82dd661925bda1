#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "profiler/executable.hpp"
#include "profiler/subprocess.hpp"
#include "tests/paths.hpp"
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
kernel void half_half(global uint* out) {
  uint i = get_global_id(0);
  if (i & 1) {
    for (uint k = 0; k < i; ++k) out[i] += out[k] * 3 + k;
  } else {
    out[i] = i * 7;
  }
}
)";

TEST(Executable, RunsAKernelInEveryTraceMode) {
  for (const TraceMode mode : {TraceMode::none, TraceMode::blocks, TraceMode::blocks_and_addresses}) {
    const auto executable = compile_kernel(half_half, "half_half", mode);
    std::vector<std::uint32_t> out(64, 1);
    run_launch(*executable, line_of(64, 32), {buffer_of(out)});
    std::vector<std::uint32_t> expected(64, 1);
    for (std::uint32_t i = 0; i < 64; ++i) {
      if (i & 1)
        for (std::uint32_t k = 0; k < i; ++k) expected[i] += expected[k] * 3 + k;
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

TEST(Executable, RefusalsNameTheLineOfTheSource) {
  const std::string message = refusal(
      [] { compile_kernel("int other(int);\nkernel void k(global int* a) {\n  a[0] = other(1);\n}", "k"); });
  EXPECT_THAT(message, testing::MatchesRegex(
                           "kernel.cl, PTX line [0-9]+ \\(kernel.cl:3\\): call of 'other', which has no body "
                           "here; expected functions of this module"));
}

// CUDA's PTX as nvcc writes it: a called function, parameters that do not say that they are pointers, a
// struct.
TEST(Executable, RunsWhatNvccCompiled) {
  struct Limits {
    std::uint32_t most;
    float scale;
  };
  const std::string ptx = read_text(source_path("tests/profiler/data/collatz.ptx"));
  const auto executable = Executable::compile(ptx, "collatz", TraceMode::blocks_and_addresses, "collatz.ptx");
  std::vector<std::uint32_t> in(256), out(257), steps(256);
  for (std::uint32_t i = 0; i < 256; ++i) {
    in[i] = i * 37 + 1;
    for (std::uint32_t x = in[i]; x != 1 && steps[i] < 90; ++steps[i]) x = x & 1 ? 3 * x + 1 : x / 2;
  }
  const std::vector<KernelArgument> arguments{buffer_of(out), buffer_of(in), scalar_of(Limits{90, 5.0f})};
  run_launch(*executable, line_of(256, 64), arguments);
  const std::uint32_t bonus[] = {1, 10, 100, 1000};
  for (std::uint32_t i = 0; i < 256; ++i) EXPECT_EQ(out[i], steps[i ^ 63] * 4 + bonus[i % 4] + 5) << i;
  EXPECT_EQ(out[256], *std::max_element(steps.begin(), steps.end()));
  EXPECT_EQ(executable->graph().files[0], "collatz.cu");
}

}  // namespace
}  // namespace warpgrain::profiler
