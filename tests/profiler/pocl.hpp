#pragma once
// Runs an OpenCL C kernel on PoCL, the reference for what kernels compute.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "profiler/launch.hpp"

namespace warpgrain::profiler {

class Pocl {
 public:
  // `options` are those of clBuildProgram. Throws std::runtime_error when there is no PoCL device.
  explicit Pocl(std::string options = "-cl-std=CL1.2");
  ~Pocl();
  // Runs the kernel and leaves the buffers as it leaves them. Throws std::runtime_error with PoCL's message.
  void run(const std::string& source, const std::string& kernel, const LaunchShape& shape,
           const std::vector<KernelArgument>& arguments);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace warpgrain::profiler
