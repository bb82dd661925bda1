#include "profiler/shared_memory.hpp"

#include <algorithm>
#include <new>
#include <sys/mman.h>

namespace warpgrain::profiler {

SharedMemory::SharedMemory(std::size_t bytes) : size_(bytes) {
  // mmap refuses a length of 0.
  void* memory = mmap(nullptr, std::max<std::size_t>(bytes, 1), PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_32BIT, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  memory_ = static_cast<std::byte*>(memory);
}

SharedMemory::~SharedMemory() { munmap(memory_, std::max<std::size_t>(size_, 1)); }

}  // namespace warpgrain::profiler
