#pragma once
// The order of what the work-items of one group do: a count of their meetings (barriers, and operations
// between the lanes of a warp), and who took part in which.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace warpgrain::profiler {

class GroupClock {
 public:
  // Times are remembered by so many bits.
  static constexpr unsigned bits = 15;
  static constexpr std::uint64_t period = std::uint64_t{1} << bits;

  explicit GroupClock(std::size_t lanes) : met_group_(lanes, 0), met_warp_(lanes, 0) {}

  void reset() {
    now_ = 0;
    std::fill(met_group_.begin(), met_group_.end(), 0);
    std::fill(met_warp_.begin(), met_warp_.end(), 0);
  }
  void meet(std::span<const std::size_t> lanes, bool of_warp) {
    ++now_;
    for (const std::size_t lane : lanes) (of_warp ? met_warp_ : met_group_)[lane] = now_;
  }
  std::uint64_t now() const { return now_; }

  // Whether what `first` did at `time` (its low bits) came before what `second` does now: both have met
  // since, as far as this clock tells. A meeting in two parts counts as one.
  bool ordered(std::size_t first, std::size_t second, std::uint64_t time) const {
    const std::uint64_t age = (now_ - time) % period;
    std::uint64_t met = std::min(met_group_[first], met_group_[second]);
    if (first / lanes_of_warp == second / lanes_of_warp)
      met = std::max(met, std::min(std::max(met_warp_[first], met_group_[first]),
                                   std::max(met_warp_[second], met_group_[second])));
    const std::uint64_t since = now_ - met;
    return age > since || (since >= period);
  }

 private:
  static constexpr std::size_t lanes_of_warp = 32;
  std::uint64_t now_ = 0;
  std::vector<std::uint64_t> met_group_, met_warp_;  // [lanes]: when last
};

}  // namespace warpgrain::profiler
