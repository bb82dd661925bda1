#pragma once
// The shared (__local) memory of a work-group.

#include <cstddef>
#include <span>

namespace warpgrain::profiler {

// Lies in the lowest 4 GiB: nvcc keeps addresses of shared memory in 32-bit registers. Aligned as a page.
class SharedMemory {
 public:
  // Throws std::bad_alloc when there is no place.
  explicit SharedMemory(std::size_t bytes);
  ~SharedMemory();
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  std::span<std::byte> bytes() const { return {memory_, size_}; }

 private:
  std::byte* memory_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace warpgrain::profiler
