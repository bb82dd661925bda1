#include "variants/backend_opencl.hpp"

#include "variants/device_simulation.hpp"
#include "variants/opencl_device.hpp"
#include "variants/precisions.hpp"
#include "variants/searches.hpp"

namespace warpgrain {
namespace {

std::string lacks() {
  return count_opencl_devices() > 0 ? "" : "no OpenCL device: install a driver, such as pocl-opencl-icd";
}

std::unique_ptr<Simulation> create(const Scene& scene, const Variant& variant,
                                   const BackendOptions& options) {
  std::vector<std::string> extensions;
  if (precision_of(variant).is_fp64) extensions.emplace_back("cl_khr_fp64");
  if (search_of(variant).needs_long_atomics) extensions.emplace_back("cl_khr_int64_base_atomics");
  return std::make_unique<DeviceSimulation>(
      scene, variant, options, open_opencl_device(options.device, extensions, options.ptx_folder));
}

}  // namespace

const Backend opencl_backend{"opencl", "any OpenCL device", lacks, create};

}  // namespace warpgrain
