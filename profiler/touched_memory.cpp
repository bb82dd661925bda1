#include "profiler/touched_memory.hpp"

#include <bit>
#include <utility>

#include "profiler/coalescing.hpp"

namespace warpgrain::profiler {

void add_sector(TouchedMemory& memory, std::uint64_t address) {
  const std::uint64_t sector = address / sector_bytes, number = sector / 64;
  if (memory.empty() || memory.back().number != number) memory.push_back({number, 0});
  memory.back().sectors |= std::uint64_t{1} << sector % 64;
}

void add(TouchedMemory& memory, std::span<const TouchedChunk> more) {
  TouchedMemory sum;
  sum.reserve(memory.size() + more.size());
  auto own = memory.begin();
  for (const TouchedChunk& chunk : more) {
    while (own != memory.end() && own->number < chunk.number) sum.push_back(*own++);
    sum.push_back(chunk);
    if (own != memory.end() && own->number == chunk.number) sum.back().sectors |= (own++)->sectors;
  }
  sum.insert(sum.end(), own, memory.end());
  memory = std::move(sum);
}

std::uint64_t bytes_of(std::span<const TouchedChunk> memory) {
  std::uint64_t sectors = 0;
  for (const TouchedChunk& chunk : memory)
    sectors += static_cast<std::uint64_t>(std::popcount(chunk.sectors));
  return sectors * sector_bytes;
}

}  // namespace warpgrain::profiler
