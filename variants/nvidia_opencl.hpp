#pragma once
// What the compiler in NVIDIA's OpenCL driver makes of a program: it hands out PTX as the program's binary.

#include <string>
#include <string_view>

namespace warpgrain {

struct NvidiaPtx {
  std::string ptx;
  std::string driver;  // "NVIDIA's OpenCL, driver 580.159.04"
};

// Throws InputError with the compiler's log, or where there is no such driver with a device.
NvidiaPtx nvidia_opencl_ptx(std::string_view source, const std::string& build_options);

}  // namespace warpgrain
