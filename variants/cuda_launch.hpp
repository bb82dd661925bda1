#pragma once
// One launch of a kernel on a CUDA device, as often as wanted and each time over the same data.

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "profiler/kernel_signature.hpp"
#include "profiler/launch.hpp"
#include "variants/cuda_driver.hpp"
#include "variants/cuda_helpers.hpp"
#include "variants/cuda_program.hpp"

namespace warpgrain {

class CudaLaunch {
 public:
  // Copies the arguments' data to the device, which outlives the launch. `arguments`: one a parameter. Throws
  // InputError naming `where`.
  CudaLaunch(const CudaDevice& device, const CudaProgram& program, const profiler::KernelSignature& signature,
             const profiler::LaunchShape& shape, std::span<const profiler::KernelArgument> arguments,
             std::string_view where);

  // Gives the buffers their first contents, runs the kernel `times` times in a row, each over what the one
  // before left, and waits for the last. Seconds on the device's clock, of all together.
  double run(unsigned times = 1);
  // The same for a profiler, which sees the kernel alone.
  void run_marked();
  // What argument `k`, a buffer, holds now. [its size]
  void read(std::size_t k, std::span<std::byte> bytes) const { buffers_[k].now.read(bytes); }
  const CudaFunction& function() const { return function_; }
  // Of a work-group, both kinds.
  int shared_bytes() const { return function_.static_shared_bytes() + static_cast<int>(added_shared_bytes_); }

 private:
  struct Buffer {
    CudaMemory first, now;
  };

  void restore();
  void launch();
  void place_shared_memory(const profiler::KernelSignature& signature,
                           std::span<const profiler::KernelArgument> arguments);

  const CudaDevice* device_;
  CudaModule module_;
  CudaFunction function_;
  profiler::LaunchShape shape_;
  std::vector<Buffer> buffers_;                 // [arguments]; empty for others
  std::vector<std::vector<std::byte>> values_;  // [parameters of the device]
  std::uint32_t added_shared_bytes_ = 0;
  CudaDelay delay_;
  CudaEvent begin_, end_;
};

}  // namespace warpgrain
