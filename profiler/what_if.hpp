#pragma once
// Questions about a launch that the traces of its lanes answer without another run: how would other warps
// have fared?

#include <cstdint>
#include <vector>

#include "profiler/merge_policy.hpp"
#include "profiler/thread_order.hpp"

namespace warpgrain::profiler {

struct WhatIf {
  std::uint32_t warp_width = 32;  // 4 to 64, a power of two
  MergePolicy policy = MergePolicy::loop_postdom;
  // Threads in another order fill the launch's work-groups anew. Those of a kernel with barriers move within
  // their work-group alone. Requests to memory are counted in the launched order alone.
  ThreadOrder order;
  // Not 0: the bound of formation_bound.hpp for pools of so many threads, a power of two from the warp width
  // to max_pool; `policy` does not count.
  std::uint32_t pool = 0;
  bool operator==(const WhatIf&) const = default;
};

inline constexpr std::uint32_t max_pool = 1024;

}  // namespace warpgrain::profiler
