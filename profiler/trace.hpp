#pragma once
// What a lane leaves behind: the blocks it ran and the addresses it touched.

#include <cstdint>

namespace warpgrain::profiler {

using BlockIndex = std::uint16_t;
// Kernels have fewer blocks than this, which the translator checks.
inline constexpr BlockIndex trace_end = 0xFFFF;

// In place of the address of an access that a false predicate kept from happening (`@%p ld...` in
// straight-line code).
inline constexpr std::uint64_t no_address = 0;

// `blocks` holds the recorded blocks in order, then trace_end; three more entries can be read (they mean
// nothing), so that readers may take four at a time. `addresses` holds BasicBlock::accesses.size() entries
// for each block run, recorded or not; null when addresses were not asked for. A lane that does not exist
// (the last warp of a work-group whose size is no multiple of the width) has null `blocks`. Device buffers
// are 256-byte aligned as on a GPU, so `address / 32` is the sector.
struct LaneTrace {
  const BlockIndex* blocks = nullptr;
  const std::uint64_t* addresses = nullptr;
};

}  // namespace warpgrain::profiler
