#pragma once
// The efficiency that dynamic warp formation could reach at best.
//
// Dynamic warp formation (Fung, Sham, Yuan and Aamodt, "Dynamic Warp Formation and Scheduling for Efficient
// GPU Control Flow", MICRO 2007) regroups the threads of a multiprocessor that stand at the same block into
// new warps. What it reaches depends on its scheduler: which block runs first, and how long a warp waits for
// more threads. The bound is what no scheduler can beat. In a pool of threads of which thread t runs block b
// c(b, t) times,
//
//   issues(b) >= max( ceil( sum_t c(b, t) / warp_width ),  max_t c(b, t) ),
//
// since an issue serves at most warp_width threads, and each at most once. For a block alone both together
// are enough (McNaughton, "Scheduling with Deadlines and Loss Functions", Management Science 6, 1959:
// preemptive jobs on warp_width equal machines end after the larger of the mean load and the longest job);
// that the order of blocks within a thread allows it for all blocks at once is not said, so the sum over
// blocks is a bound on warp instructions from below, and thread instructions / (warp_width * that) a bound on
// SIMT efficiency from above.

#include <cstdint>
#include <span>
#include <vector>

#include "profiler/kernel_graph.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler {

struct FormationPool {
  std::uint32_t threads = 0;  // of the pool; threads t with the same t / threads share one
  std::uint32_t warp_width = 0;
  bool operator==(const FormationPool&) const = default;
};

class FormationBound {
 public:
  FormationBound(const KernelGraph& graph, std::vector<FormationPool> pools);

  // The next threads, numbered from `first_thread` on in ascending order from call to call; null traces stand
  // for threads that do not exist.
  void add(std::uint64_t first_thread, std::span<const LaneTrace> lanes);
  // No pool goes on beyond the threads added so far.
  void end_pools();

  struct Counts {
    std::vector<std::uint64_t> issues;      // [n_blocks]
    std::vector<std::uint64_t> executions;  // [n_blocks], by threads
    std::uint64_t pools = 0;
  };
  // Of pools that ended; one for each of `pools`.
  const std::vector<Counts>& counts() const { return counts_; }
  void add_counts(const FormationBound& other);

 private:
  struct OpenPool {  // of one size
    std::uint32_t threads = 0;
    std::uint64_t number = 0;
    bool used = false;
    std::vector<std::uint64_t> sum, most;  // [n_blocks]: c over threads
  };
  void add_lane(std::uint64_t thread, const BlockIndex* blocks);
  void end(OpenPool& pool);

  std::vector<std::vector<std::uint32_t>> runs_;
  std::vector<FormationPool> pools_;
  std::vector<Counts> counts_;              // [pools_]
  std::vector<OpenPool> open_;              // one a size
  std::vector<std::uint64_t> of_lane_;      // [n_blocks]: how often the lane ran it
  std::vector<std::uint32_t> ran_by_lane_;  // blocks above zero in it
};

}  // namespace warpgrain::profiler
