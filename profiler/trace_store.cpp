#include "profiler/trace_store.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain::profiler {
namespace {

constexpr std::size_t entries_a_piece = std::size_t{1} << 18;
// Its trace, and in thread_permutation.cpp its count and two lists of places and threads.
constexpr std::uint64_t bytes_a_thread = sizeof(const BlockIndex*) + 4 * sizeof(std::uint64_t);
constexpr std::size_t readable_behind = 3;  // what trace.hpp promises readers
// Of the table that finds equal traces, a distinct one: key, pointer, chain, hash and bucket.
constexpr std::uint64_t bytes_a_table_entry = 40;

}  // namespace

TraceStore::TraceStore(std::uint64_t n_threads, std::uint64_t limit) : limit_(limit) {
  count(n_threads * bytes_a_thread);
  traces_.resize(n_threads);
}

void TraceStore::count(std::uint64_t bytes) {
  bytes_ += bytes;
  if (bytes_ > limit_)
    throw_input_error("--what-if order",
                      fmt::format("the traces of the launch's threads take more than {} MiB", limit_ >> 20),
                      "fewer threads, or a larger --trace-memory");
}

BlockIndex* TraceStore::allocate(std::size_t entries, std::uint64_t distinct_traces) {
  const std::lock_guard lock(mutex_);
  count(entries * sizeof(BlockIndex) + distinct_traces * bytes_a_table_entry);
  memory_.push_back(std::make_unique<BlockIndex[]>(entries));
  return memory_.back().get();
}

void TraceStore::Writer::keep(std::uint64_t first_thread, std::span<const LaneTrace> lanes) {
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    if (lanes[lane].blocks != nullptr) store_.traces_[first_thread + lane] = kept(lanes[lane].blocks);
}

const BlockIndex* TraceStore::Writer::kept(const BlockIndex* blocks) {
  std::uint64_t hash = 0;
  const BlockIndex* end = blocks;
  do {
    hash = (hash ^ *end) * 0x9E3779B97F4A7C15U;  // 2^64 / golden ratio
    hash ^= hash >> 29;
  } while (*end++ != trace_end);
  const auto length = static_cast<std::size_t>(end - blocks);
  const BlockIndex*& known = by_hash_[hash];
  // The comparison ends at the first difference, at the latest at the end of the shorter one.
  if (known != nullptr && std::equal(blocks, end, known)) return known;
  if (n_free_ < length + readable_behind) {
    n_free_ = std::max(entries_a_piece, length + readable_behind);
    free_ = store_.allocate(n_free_, by_hash_.size() - n_counted_);
    n_counted_ = by_hash_.size();
  }
  const BlockIndex* const copy = free_;
  free_ = std::copy(blocks, end, free_);
  n_free_ -= length;
  known = copy;
  return copy;
}

}  // namespace warpgrain::profiler
