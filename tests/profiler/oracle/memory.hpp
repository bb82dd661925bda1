#pragma once
// The interpreter's memory: one flat space of made-up addresses, in which every access is checked. Each
// region has 2^36 addresses of its own, so that running off one never ends in another.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace warpgrain::oracle {

class Memory {
 public:
  // Regions that every launch has; its buffers are the ones from first_buffer on.
  enum Region : std::uint32_t { shared, parameters, local, variables, first_buffer };

  // Where the region begins: shared memory where 32 bits reach it, all aligned to a page.
  static std::uint64_t base_of(std::uint32_t region) { return (std::uint64_t{region} << 36) + 0x1000000; }

  Memory() : regions_(first_buffer) {}
  void set(Region region, std::span<std::byte> bytes) { regions_[region] = bytes; }
  // Appends a buffer and returns its address: 0 for an empty one.
  std::uint64_t add_buffer(std::span<std::byte> bytes);

  // Throws std::out_of_range for accesses that leave their region, std::runtime_error for misaligned ones.
  std::byte* at(std::uint64_t address, std::uint32_t bytes) const;

  // Whether it is known how the address lies to sectors on a device: of buffers alone.
  static bool in_buffer(std::uint64_t address) { return address >> 36 >= first_buffer; }

 private:
  std::vector<std::span<std::byte>> regions_;
};

}  // namespace warpgrain::oracle
