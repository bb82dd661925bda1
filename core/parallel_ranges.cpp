#include "core/parallel_ranges.hpp"

#include <algorithm>
#include <exception>
#include <thread>

namespace warpgrain {

std::vector<IndexRange> split_ranges(std::size_t n, unsigned threads) {
  // Below some thousand particles a step is shorter than the start of a thread.
  constexpr std::size_t worth_a_thread = 2048;
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t n_ranges = std::clamp<std::size_t>(n / worth_a_thread, 1, threads);
  std::vector<IndexRange> ranges(n_ranges);
  for (std::size_t k = 0; k < n_ranges; ++k) ranges[k] = {n * k / n_ranges, n * (k + 1) / n_ranges};
  return ranges;
}

void for_each_range(std::size_t n_ranges, const std::function<void(std::size_t)>& work) {
  std::vector<std::exception_ptr> errors(n_ranges);
  const auto guarded = [&](std::size_t k) {
    try {
      work(k);
    } catch (...) {
      errors[k] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t k = 1; k < n_ranges; ++k) threads.emplace_back(guarded, k);
    guarded(0);
  }
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

}  // namespace warpgrain
