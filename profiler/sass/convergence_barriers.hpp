#pragma once
// The barriers of a warp, B0 to B15: which lanes are to meet at each.
//
// A barrier is one mask for the whole warp. BSSY adds lanes to it, BREAK takes lanes out, and a BSYNC whose
// lanes have all come empties it (US patent 10,067,768, and what an H100 counts).

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "profiler/sass/lane_mask.hpp"

namespace warpgrain::profiler::sass {

class ConvergenceBarriers {
 public:
  static constexpr std::size_t count = 16;

  void clear() {
    masks_.assign(count, 0);
    for (auto& of_barrier : levels_) of_barrier.fill(0);
  }

  // The mask of the barrier for a group of lanes that run together.
  Mask& at(std::uint8_t barrier, Mask lanes) { return masks_[index(barrier, lanes)]; }
  Mask at(std::uint8_t barrier, Mask lanes) const { return masks_[index(barrier, lanes)]; }
  // Whether two groups mean the same mask by a barrier.
  bool is_same(std::uint8_t barrier, Mask a, Mask b) const { return index(barrier, a) == index(barrier, b); }

  // BMOV: a function puts the mask aside to use the barrier itself, and back at its end. Lanes that have put
  // it aside as often share it: other groups may be in the function, too.
  void save(std::uint8_t barrier, Mask lanes) {
    for_lanes(lanes, [&](std::uint32_t lane) { ++levels_[barrier][lane]; });
    if (index(barrier, lanes) >= masks_.size()) masks_.resize(masks_.size() + count);
  }
  void restore(std::uint8_t barrier, Mask lanes) {
    for_lanes(lanes, [&](std::uint32_t lane) {
      if (levels_[barrier][lane] != 0) --levels_[barrier][lane];
    });
  }

 private:
  std::size_t index(std::uint8_t barrier, Mask lanes) const {
    return levels_[barrier][static_cast<std::size_t>(std::countr_zero(lanes))] * count + barrier;
  }

  std::vector<Mask> masks_ = std::vector<Mask>(count);         // [levels][barriers]
  std::array<std::array<std::uint32_t, 32>, count> levels_{};  // how often each lane has put each aside
};

}  // namespace warpgrain::profiler::sass
