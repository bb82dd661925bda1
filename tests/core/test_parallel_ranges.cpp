#include <atomic>
#include <gtest/gtest.h>
#include <stdexcept>

#include "core/parallel_ranges.hpp"

namespace warpgrain {
namespace {

TEST(ParallelRanges, CoverEverythingOnce) {
  for (std::size_t n : {0u, 1u, 5000u, 100001u})
    for (unsigned threads : {0u, 1u, 3u, 8u}) {
      std::size_t next = 0;
      for (const IndexRange& range : split_ranges(n, threads)) {
        EXPECT_EQ(range.first, next);
        next = range.last;
      }
      EXPECT_EQ(next, n);
    }
  EXPECT_EQ(split_ranges(100001, 8).size(), 8u);
  EXPECT_EQ(split_ranges(10, 8).size(), 1u);
}

TEST(ParallelRanges, RethrowTheErrorOfTheLowestRange) {
  std::atomic<int> calls = 0;
  const auto work = [&](std::size_t k) {
    ++calls;
    if (k >= 2) throw std::runtime_error("range " + std::to_string(k));
  };
  try {
    for_each_range(6, work);
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_STREQ(e.what(), "range 2");
  }
  EXPECT_EQ(calls, 6);
}

}  // namespace
}  // namespace warpgrain
