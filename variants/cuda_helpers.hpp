#pragma once
// Two small kernels of our own that launches on a CUDA device need beside them.

#include <cstdint>

#include "variants/cuda_driver.hpp"

namespace warpgrain {

// Keeps the device busy while the host hands in what is to be timed: without it the time between two events
// would be the host's, not the kernel's.
class CudaDelay {
 public:
  explicit CudaDelay(const CudaDevice& device);
  void launch(double seconds) const;

 private:
  CudaModule module_;
  CudaFunction function_;
};

// Where the shared memory that a launch adds begins, for a kernel with that much of its own; a multiple of
// 256. The launch must ask for up to 255 bytes more than it uses. Drivers keep some for themselves before it,
// and say nowhere how much, so a kernel is asked.
std::uint64_t shared_memory_begin(const CudaDevice& device, int static_bytes);

}  // namespace warpgrain
