#pragma once
// Memory for what the lanes of a work-group leave behind, a stretch a lane. Pages exist from the first write
// on, so that long limits cost nothing until a lane is that long.

#include <cstddef>
#include <cstdint>

namespace warpgrain::profiler {

class LaneBuffers {
 public:
  // Throws std::bad_alloc when the address space is not to be had.
  LaneBuffers(std::size_t lanes, std::size_t bytes_per_lane);
  ~LaneBuffers();
  LaneBuffers(const LaneBuffers&) = delete;
  LaneBuffers& operator=(const LaneBuffers&) = delete;

  std::byte* lane(std::size_t index) const { return memory_ + index * stride_; }
  // Gives back the pages of a lane that wrote `used` bytes, but for the first ones, which most lanes need
  // again.
  void release(std::size_t index, std::size_t used);

 private:
  std::byte* memory_ = nullptr;
  std::size_t stride_ = 0;
  std::size_t size_ = 0;
};

}  // namespace warpgrain::profiler
