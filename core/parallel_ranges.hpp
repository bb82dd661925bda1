#pragma once
// Work split over threads by contiguous ranges of indices. What is computed for an index must not depend on
// the range it falls in: then results are the same bits for any number of threads.

#include <cstddef>
#include <functional>
#include <vector>

namespace warpgrain {

struct IndexRange {
  std::size_t first = 0, last = 0;  // half open
  std::size_t size() const { return last - first; }
};

// Covers [0, n) with at most `threads` (0: as many as there are cores) ranges of about the same size, fewer
// when n is too small to be worth a thread's start. At least one range, maybe empty.
std::vector<IndexRange> split_ranges(std::size_t n, unsigned threads);

// Calls work(k) for k in [0, n_ranges), each on a thread of its own but the first, which runs here. When
// several throw, the exception of the lowest range is rethrown.
void for_each_range(std::size_t n_ranges, const std::function<void(std::size_t)>& work);

}  // namespace warpgrain
