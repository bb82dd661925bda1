#pragma once
// Keeps the block traces of a whole launch, for questions that need lanes from all over it. Equal traces are
// kept once: lanes that do the same are common, and often all do.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <unordered_map>
#include <vector>

#include "profiler/trace.hpp"

namespace warpgrain::profiler {

class TraceStore {
 public:
  // Throws InputError as soon as more than `limit` bytes would be held.
  TraceStore(std::uint64_t n_threads, std::uint64_t limit);

  // Takes traces into the store, which outlives it. One for each thread of the program, for different threads
  // of the launch.
  class Writer {
   public:
    explicit Writer(TraceStore& store) : store_(store) {}
    // Null traces stand for threads that do not exist.
    void keep(std::uint64_t first_thread, std::span<const LaneTrace> lanes);

   private:
    const BlockIndex* kept(const BlockIndex* blocks);

    TraceStore& store_;
    BlockIndex* free_ = nullptr;
    std::size_t n_free_ = 0;
    std::unordered_map<std::uint64_t, const BlockIndex*> by_hash_;
    std::size_t n_counted_ = 0;  // of it, towards the limit
  };

  // Of a thread; null blocks for one that does not exist, and no addresses.
  LaneTrace trace(std::uint64_t thread) const { return {traces_[thread], nullptr}; }
  std::uint64_t n_threads() const { return traces_.size(); }
  std::uint64_t bytes() const { return bytes_; }

 private:
  void count(std::uint64_t bytes);
  BlockIndex* allocate(std::size_t entries, std::uint64_t distinct_traces);

  std::uint64_t limit_;
  std::vector<const BlockIndex*> traces_;  // [n_threads]
  std::mutex mutex_;                       // of what follows
  std::uint64_t bytes_ = 0;
  std::vector<std::unique_ptr<BlockIndex[]>> memory_;
};

}  // namespace warpgrain::profiler
