#pragma once
// A CUDA device that runs the step plan: the PTX that the simulator runs or that another compiler makes of
// the kernels, loaded by CUDA's driver.

#include <memory>
#include <string>

#include "variants/compute_device.hpp"

namespace warpgrain {

// Empty when the back end can be used here; else what is missing, in one line.
std::string cuda_device_lacks();

// The device whose name contains `options.device`; empty: the first. Throws InputError that lists the devices
// there are, or with cuda_device_lacks().
std::unique_ptr<ComputeDevice> open_cuda_device(const BackendOptions& options);

}  // namespace warpgrain
