// Kernels of CUDA whose lanes work together, from the PTX that nvcc made of them and, where there is nvcc,
// from their source.

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

#include "profiler/cuda_frontend.hpp"
#include "profiler/subprocess.hpp"
#include "tests/paths.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

const std::filesystem::path warp_kernels_files = source_path("tests/profiler/data");

bool has_nvcc() {
  return !find_program("nvcc").empty() || std::filesystem::exists("/usr/local/cuda/bin/nvcc");
}

class WarpKernels : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const bool from_source = std::string_view(GetParam()) == "source";
    if (from_source && !has_nvcc()) GTEST_SKIP() << "no nvcc on PATH or in /usr/local/cuda/bin";
    static const std::string committed = read_text(warp_kernels_files / "warp_kernels.ptx");
    static const std::string compiled =
        has_nvcc() ? compile_cuda(warp_kernels_files / "warp_kernels.cu", "").ptx : std::string();
    ptx_ = from_source ? compiled : committed;
    std::mt19937 random(7);
    for (int& x : in_) x = static_cast<int>(random() % 200) - 60;
  }

  void run(const std::string& kernel, const LaunchShape& shape,
           const std::vector<KernelArgument>& arguments) {
    const auto executable =
        Executable::compile(ptx_, kernel, TraceMode::blocks_and_addresses, "warp_kernels.cu");
    run_launch(*executable, shape, arguments);
  }

  std::string ptx_;
  std::vector<int> in_ = std::vector<int>(512), out_ = std::vector<int>(512);
};

TEST_P(WarpKernels, ShuffleReduction) {
  run("shuffle_reduction", line_of(512, 128), {buffer_of(out_), buffer_of(in_)});
  for (std::size_t block = 0; block < 4; ++block)
    EXPECT_EQ(out_[block], std::accumulate(&in_[block * 128], &in_[block * 128] + 128, 0));
}

TEST_P(WarpKernels, WarpScan) {
  run("warp_scan", line_of(512, 64), {buffer_of(out_), buffer_of(in_)});
  for (std::size_t i = 0; i < 512; ++i)
    EXPECT_EQ(out_[i], std::accumulate(&in_[i / 32 * 32], &in_[i] + 1, 0));
}

TEST_P(WarpKernels, BallotCompaction) {
  std::vector<int> counts(16);
  run("ballot_compaction", line_of(512, 256), {buffer_of(out_), buffer_of(counts), buffer_of(in_)});
  for (std::size_t warp = 0; warp < 16; ++warp) {
    std::vector<int> kept;
    std::copy_if(&in_[warp * 32], &in_[warp * 32] + 32, std::back_inserter(kept),
                 [](int x) { return x > 0; });
    EXPECT_EQ(counts[warp], static_cast<int>(kept.size()));
    kept.resize(32);
    EXPECT_EQ(std::vector<int>(&out_[warp * 32], &out_[warp * 32] + 32), kept);
  }
}

TEST_P(WarpKernels, MatchHistogram) {
  std::vector<int> bins(8), expected(8);
  for (int& x : in_) ++expected[static_cast<std::size_t>(x = (x + 60) % 8)];
  run("match_histogram", line_of(512, 64), {buffer_of(bins), buffer_of(in_)});
  EXPECT_EQ(bins, expected);
}

TEST_P(WarpKernels, TransposeInSharedMemoryOfTheLaunch) {
  const int width = 16;
  run("transpose<int>", {{16, 16, 1}, {8, 8, 1}},
      {buffer_of(out_), buffer_of(in_), scalar_of(width), KernelArgument::local(8 * 9 * 4)});
  for (std::size_t y = 0; y < 16; ++y)
    for (std::size_t x = 0; x < 16; ++x) EXPECT_EQ(out_[y * 16 + x], in_[x * 16 + y]);
}

TEST_P(WarpKernels, ProducerAndConsumerAtNumberedBarriers) {
  const int rounds = 5;
  run("producer_consumer", line_of(64, 64), {buffer_of(out_), buffer_of(in_), scalar_of(rounds)});
  for (std::size_t i = 0; i < 5 * 32; ++i) EXPECT_EQ(out_[i], 3 * in_[i / 32 * 32 + 31 - i % 32]);
}

TEST_P(WarpKernels, VotesOfThoseLeftInALoop) {
  for (int& x : in_) x += 60;
  run("loop_of_votes", line_of(512, 32), {buffer_of(out_), buffer_of(in_)});
  for (std::size_t i = 0; i < 512; ++i) {
    const int* const warp = &in_[i / 32 * 32];
    int seen = 0;
    for (int trip = 0; trip < in_[i] % 7; ++trip)
      seen += static_cast<int>(std::count_if(warp, warp + 32, [&](int x) { return x % 7 > trip; }));
    EXPECT_EQ(out_[i], seen) << i;
  }
}

TEST_P(WarpKernels, CallsThroughTablesOfFunctions) {
  for (int& x : in_) x += 60;
  run("virtual_calls", line_of(512, 32), {buffer_of(out_), buffer_of(in_)});
  for (std::size_t i = 0; i < 512; ++i) {
    int stripes = 0;
    for (int k = 0; k < in_[i]; ++k) stripes += k % 3;
    EXPECT_EQ(out_[i], in_[i] % 2 == 0 ? in_[i] * in_[i] : stripes);
  }
}

INSTANTIATE_TEST_SUITE_P(From, WarpKernels, testing::Values("ptx", "source"));

}  // namespace
}  // namespace warpgrain::profiler
