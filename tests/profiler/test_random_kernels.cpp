// 250 random kernels (tests/profiler/oracle/random_kernel.hpp): the simulator leaves the same bytes as PoCL
// and counts what the interpreter counts. The program random_kernels runs as many more as one has time for.

#include <gtest/gtest.h>

#include "tests/profiler/oracle/random_check.hpp"
#include "tests/profiler/pocl.hpp"

namespace warpgrain::oracle {
namespace {

constexpr std::uint64_t n_kernels = 250, kernels_a_program = 50;

class RandomKernels : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomKernels, AgreeWithPoclAndWithTheInterpreter) {
  std::vector<RandomKernel> kernels;
  for (std::uint64_t i = 0; i < kernels_a_program; ++i) kernels.push_back(random_kernel(GetParam() + i));
  static profiler::Pocl pocl(reference_options);
  const auto findings = check_kernels(kernels, [](const auto&... launch) { pocl.run(launch...); });
  for (const Finding& finding : findings) ADD_FAILURE() << report(finding);
}

INSTANTIATE_TEST_SUITE_P(From, RandomKernels,
                         testing::Range(std::uint64_t{1}, n_kernels + 1, kernels_a_program));

TEST(RandomKernels, InPtxAgreeWithTheInterpreter) {
  std::vector<RandomKernel> kernels;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) kernels.push_back(random_ptx_kernel(seed));
  for (const Finding& finding : check_ptx_kernels(kernels)) ADD_FAILURE() << report(finding);
}

TEST(RandomKernel, IsTheSameForTheSameSeed) {
  EXPECT_EQ(random_kernel(7).source, random_kernel(7).source);
  EXPECT_NE(random_kernel(7).source, random_kernel(8).source);
}

}  // namespace
}  // namespace warpgrain::oracle
