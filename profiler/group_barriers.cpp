#include "profiler/group_barriers.hpp"

#include <algorithm>

#include "profiler/warp_exchange.hpp"

namespace warpgrain::profiler {

GroupBarriers::GroupBarriers(std::size_t warps) {
  for (Barrier& barrier : barriers_) barrier.came.assign(warps, 0);
}

void GroupBarriers::reset() {
  for (std::size_t i = 0; i < count; ++i)
    if (barriers_[i].in_use) clear(i);
}

void GroupBarriers::clear(std::size_t barrier) {
  barriers_[barrier].in_use = false;
  std::ranges::fill(barriers_[barrier].came, 0U);
}

std::string_view GroupBarriers::arrive(const Rendezvous& asked, std::size_t warp, std::uint32_t lane) {
  if (asked.index >= count) return "a barrier's number above 15";
  if (asked.bound % lanes_of_warp != 0) return "a thread count that is no multiple of 32";
  Barrier& barrier = barriers_[asked.index];
  if (barrier.in_use && barrier.threads != asked.bound)
    return "a thread count other than that of those who wait";
  const std::uint32_t bit = std::uint32_t{1} << lane;
  if ((barrier.came[warp] & bit) != 0) return "a second arrival before the barrier is complete";
  barrier.in_use = true;
  barrier.threads = asked.bound;
  barrier.came[warp] |= bit;
  return {};
}

bool GroupBarriers::is_complete(std::size_t index, std::span<const WarpState> warps) const {
  const Barrier& barrier = barriers_[index];
  if (!barrier.in_use) return false;
  std::uint64_t came = 0;
  for (std::size_t w = 0; w < warps.size(); ++w) {
    const bool all = (warps[w].alive & ~barrier.came[w]) == 0;
    if (barrier.threads == 0 && !all) return false;
    came += all && barrier.came[w] != 0 ? 1 : 0;
  }
  return barrier.threads == 0 || came * lanes_of_warp == barrier.threads;
}

}  // namespace warpgrain::profiler
