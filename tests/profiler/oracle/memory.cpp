#include "tests/profiler/oracle/memory.hpp"

#include <fmt/format.h>
#include <stdexcept>

namespace warpgrain::oracle {

std::uint64_t Memory::add_buffer(std::span<std::byte> bytes) {
  if (bytes.empty()) return 0;
  regions_.push_back(bytes);
  return base_of(static_cast<std::uint32_t>(regions_.size() - 1));
}

std::byte* Memory::at(std::uint64_t address, std::uint32_t bytes) const {
  const std::uint64_t region = address >> 36;
  if (region < regions_.size()) {
    const std::uint64_t base = base_of(static_cast<std::uint32_t>(region));
    const std::uint64_t size = regions_[region].size();
    if (address >= base && bytes <= size && address - base <= size - bytes) {
      if (address % bytes != 0)
        throw std::runtime_error(fmt::format("misaligned access of {} bytes at {:#x}", bytes, address));
      return regions_[region].data() + (address - base);
    }
  }
  throw std::out_of_range(fmt::format("access of {} bytes at {:#x}, in no buffer", bytes, address));
}

}  // namespace warpgrain::oracle
