#include "profiler/thread_permutation.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <utility>

namespace warpgrain::profiler {
namespace {

// Fisher and Yates; std::shuffle is not the same in every library.
void shuffle(std::vector<std::uint64_t>& threads, std::mt19937_64& random) {
  for (std::size_t i = threads.size(); i > 1; --i) std::swap(threads[i - 1], threads[random() % i]);
}

}  // namespace

std::vector<std::uint64_t> permuted_threads(const ThreadOrder& order, const ThreadKey* key,
                                            const TraceStore& traces, std::uint64_t stretch) {
  std::vector<std::uint64_t> result(traces.n_threads());
  std::iota(result.begin(), result.end(), std::uint64_t{0});
  std::vector<std::uint64_t> counts;  // [n_threads]
  if (order.kind == ThreadOrder::Kind::sorted)
    for (const std::uint64_t thread : result)
      counts.push_back(traces.trace(thread).blocks ? key->count(traces.trace(thread).blocks) : 0);
  std::mt19937_64 random(order.seed);
  for (std::uint64_t begin = 0; begin < result.size(); begin += stretch) {
    const std::uint64_t end = std::min<std::uint64_t>(begin + stretch, result.size());
    std::vector<std::uint64_t> places, threads;  // those that exist
    for (std::uint64_t thread = begin; thread < end; ++thread)
      if (traces.trace(thread).blocks != nullptr) places.push_back(thread);
    threads = places;
    if (order.kind == ThreadOrder::Kind::shuffled) shuffle(threads, random);
    if (order.kind == ThreadOrder::Kind::sorted)
      std::ranges::stable_sort(threads, {}, [&](std::uint64_t thread) { return counts[thread]; });
    for (std::size_t k = 0; k < places.size(); ++k) result[places[k]] = threads[k];
  }
  return result;
}

}  // namespace warpgrain::profiler
