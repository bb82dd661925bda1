#pragma once
// An OpenCL device of any platform that the ICD loader finds.

#include <memory>
#include <string>
#include <vector>

#include "variants/compute_device.hpp"

namespace warpgrain {

// The device whose name or platform's name contains `substring`, whatever the case; empty: the first PoCL
// device, else the first. Throws InputError that lists the devices there are, and when the device lacks one
// of the extensions. With a folder, building writes the PTX of each program there, as FIRST_KERNEL.ptx, or
// throws InputError where the device's compiler makes none.
std::unique_ptr<ComputeDevice> open_opencl_device(const std::string& substring,
                                                  const std::vector<std::string>& extensions = {},
                                                  const std::string& ptx_folder = {});

// How many devices there are.
std::size_t count_opencl_devices();

}  // namespace warpgrain
