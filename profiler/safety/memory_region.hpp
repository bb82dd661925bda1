#pragma once
// A stretch of memory that a kernel may touch: a buffer, a variable.

#include <cstdint>
#include <memory>
#include <string>

#include "profiler/access_site.hpp"
#include "profiler/safety/access_history.hpp"
#include "profiler/safety/zero_pages.hpp"

namespace warpgrain::profiler {

// What is known of the bytes of memory that one or more buffers lie in.
struct MemoryState {
  std::uint64_t begin = 0, end = 0;
  std::unique_ptr<AccessHistory> history;  // null: no races are possible
  ZeroPages<std::uint8_t> initialized;     // a byte a byte, 0: it has no value yet; none: all have
  bool needs_look() const { return history != nullptr || initialized; }
};

struct MemoryRegion {
  std::uint64_t begin = 0, size = 0;  // begin 0: a null pointer
  std::string name;
  AccessSpace space = AccessSpace::global;
  bool readable = true, writable = true;
  bool uninitialized = false;
  std::uint32_t vector_bytes = 0;  // as KernelArgument::vector_bytes
  MemoryState* state = nullptr;    // null: bounds and rights are all there is to check

  bool holds(std::uint64_t address, std::uint32_t bytes) const {
    return address - begin < size && size - (address - begin) >= bytes;
  }
};

}  // namespace warpgrain::profiler
