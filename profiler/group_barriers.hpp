#pragma once
// The sixteen numbered barriers of a work-group, as bar and barrier use them: who has come to which.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "profiler/rendezvous.hpp"

namespace warpgrain::profiler {

// The lanes of one warp by what they do, a bit each.
struct WarpState {
  std::uint32_t alive = 0;       // not ended
  std::uint32_t ready = 0;       // to run
  std::uint32_t at_barrier = 0;  // waiting for the work-group
  std::uint32_t meeting = 0;     // waiting for others of the warp
};

class GroupBarriers {
 public:
  static constexpr std::size_t count = 16;

  explicit GroupBarriers(std::size_t warps);
  void reset();

  // Lane `lane` of a warp comes to the barrier that it asks for. Says what PTX forbids about it; empty when
  // nothing.
  std::string_view arrive(const Rendezvous& asked, std::size_t warp, std::uint32_t lane);

  // Whether enough warps have come. A warp has come when all its lanes have that have not ended; without a
  // thread count, every warp has to.
  bool is_complete(std::size_t barrier, std::span<const WarpState> warps) const;
  void clear(std::size_t barrier);

 private:
  struct Barrier {
    bool in_use = false;
    std::uint32_t threads = 0;        // 0: all
    std::vector<std::uint32_t> came;  // lanes, [warps]
  };
  std::array<Barrier, count> barriers_;
};

}  // namespace warpgrain::profiler
