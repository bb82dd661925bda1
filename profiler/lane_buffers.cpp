#include "profiler/lane_buffers.hpp"

#include <new>
#include <sys/mman.h>

namespace warpgrain::profiler {
namespace {

constexpr std::size_t page = 4096;
// Beside the page, so that the lanes' cursors do not all fall into the same cache sets.
constexpr std::size_t stagger = 3 * 64;
constexpr std::size_t kept = std::size_t{256} << 10;

}  // namespace

LaneBuffers::LaneBuffers(std::size_t lanes, std::size_t bytes_per_lane)
    : stride_((bytes_per_lane + page - 1) / page * page + page + stagger), size_(lanes * stride_) {
  void* memory =
      mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  memory_ = static_cast<std::byte*>(memory);
}

LaneBuffers::~LaneBuffers() { munmap(memory_, size_); }

void LaneBuffers::release(std::size_t index, std::size_t used) {
  if (used <= kept) return;
  const std::size_t begin = index * stride_;
  const std::size_t first = (begin + kept + page - 1) / page * page;
  const std::size_t last = (begin + used) / page * page;
  if (last > first) madvise(memory_ + first, last - first, MADV_DONTNEED);
}

}  // namespace warpgrain::profiler
