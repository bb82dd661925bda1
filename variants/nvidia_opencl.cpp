#include "variants/nvidia_opencl.hpp"

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#include <CL/opencl.hpp>
#pragma GCC diagnostic pop
#include <fmt/format.h>
#include <optional>
#include <vector>

#include "core/error.hpp"
#include "variants/opencl_ptx.hpp"

namespace warpgrain {
namespace {

constexpr const char* where = "--compiler nvidia";

cl::Device nvidia_device() {
  std::vector<cl::Platform> platforms;
  std::string names;
  try {
    cl::Platform::get(&platforms);
    for (const cl::Platform& platform : platforms) {
      const auto name = platform.getInfo<CL_PLATFORM_NAME>();
      names += (names.empty() ? "" : ", ") + name;
      if (!name.starts_with("NVIDIA")) continue;
      std::vector<cl::Device> devices;
      platform.getDevices(CL_DEVICE_TYPE_GPU, &devices);
      return devices.at(0);
    }
  } catch (const cl::Error&) {  // the loader's word for none
  }
  throw_input_error(where, names.empty() ? "no OpenCL platform" : "the OpenCL platforms " + names,
                    "NVIDIA's OpenCL, which comes with the driver of an NVIDIA GPU");
}

}  // namespace

NvidiaPtx nvidia_opencl_ptx(std::string_view source, const std::string& build_options) {
  const cl::Device device = nvidia_device();
  const cl::Context context(device);
  cl::Program program(context, std::string(source));
  try {
    program.build({device}, build_options.c_str());
  } catch (const cl::Error&) {
    throw InputError(fmt::format("{}: the kernels do not compile\n{}", where,
                                 program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device)));
  }
  const auto binary = program.getInfo<CL_PROGRAM_BINARIES>().at(0);
  std::optional<std::string> ptx =
      ptx_of_binary({reinterpret_cast<const char*>(binary.data()), binary.size()});
  if (!ptx) throw_input_error(where, "a program binary that is no text", "PTX");
  return {std::move(*ptx), fmt::format("NVIDIA's OpenCL, driver {}", device.getInfo<CL_DRIVER_VERSION>())};
}

}  // namespace warpgrain
