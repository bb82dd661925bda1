#pragma once
// Which memory something touches, in sectors of 32 bytes: what several launches touch together is less than
// the sum, where they share buffers.

#include <cstdint>
#include <span>
#include <vector>

namespace warpgrain::profiler {

// 64 sectors that lie side by side.
struct TouchedChunk {
  std::uint64_t number = 0;   // the address in chunks
  std::uint64_t sectors = 0;  // a bit each, the lowest address first; never 0
  bool operator==(const TouchedChunk&) const = default;
};
using TouchedMemory = std::vector<TouchedChunk>;  // by number, each once

// `address` of the sector's first byte. Sectors are to come by address.
void add_sector(TouchedMemory& memory, std::uint64_t address);

void add(TouchedMemory& memory, std::span<const TouchedChunk> more);

std::uint64_t bytes_of(std::span<const TouchedChunk> memory);

}  // namespace warpgrain::profiler
