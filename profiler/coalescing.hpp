#pragma once
// What one warp-level memory request touches.

#include <cstdint>
#include <span>

namespace warpgrain::profiler {

inline constexpr std::uint64_t sector_bytes = 32;
inline constexpr std::uint64_t line_bytes = 128;
inline constexpr std::size_t max_request_lanes = 64;

struct RequestFootprint {
  std::uint32_t sectors = 0;  // distinct aligned 32-byte pieces
  std::uint32_t lines = 0;    // distinct aligned 128-byte pieces
};

// Of a request of one lane.
inline RequestFootprint access_footprint(std::uint64_t address, std::uint32_t bytes) {
  const std::uint64_t last = address + bytes - 1;
  return {static_cast<std::uint32_t>(last / sector_bytes - address / sector_bytes + 1),
          static_cast<std::uint32_t>(last / line_bytes - address / line_bytes + 1)};
}

// Of a request whose active lanes touch `bytes` (at least 1) bytes at each of `addresses`, [1 to
// max_request_lanes]. An access that straddles a boundary touches the pieces on both sides.
RequestFootprint request_footprint(std::span<const std::uint64_t> addresses, std::uint32_t bytes);

}  // namespace warpgrain::profiler
