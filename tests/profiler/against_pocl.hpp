#pragma once
// Kernels whose work is exact must leave the same bytes here and on PoCL.

#include <cstdint>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

#include "tests/profiler/pocl.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {

inline constexpr std::uint32_t pocl_seed = 20240601;

inline std::vector<std::uint32_t> random_words(std::size_t count) {
  std::mt19937 random(pocl_seed);
  std::vector<std::uint32_t> words(count);
  for (auto& word : words) word = random();
  return words;
}

inline Pocl& pocl() {
  static Pocl instance;
  return instance;
}

// Runs the kernel `k` of the source on both, its first two parameters being input and output words; the rest
// follow.
inline void expect_same(const std::string& source, const LaunchShape& shape,
                        const std::vector<KernelArgument>& more = {}, std::size_t words = 4096) {
  std::vector<std::uint32_t> here_in = random_words(words), there_in = here_in;
  std::vector<std::uint32_t> here_out(words), there_out(words);
  const auto arguments = [&more](auto& in, auto& out) {
    std::vector<KernelArgument> all{buffer_of(in), buffer_of(out)};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  run_launch(*compile_kernel(source, "k"), shape, arguments(here_in, here_out));
  pocl().run(source, "k", shape, arguments(there_in, there_out));
  EXPECT_EQ(here_in, there_in) << "seed " << pocl_seed;
  for (std::size_t i = 0; i < words; ++i)
    ASSERT_EQ(here_out[i], there_out[i]) << "word " << i << ", seed " << pocl_seed;
}

}  // namespace warpgrain::profiler
