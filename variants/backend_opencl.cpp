#include "variants/backend_opencl.hpp"

#include "variants/device_simulation.hpp"
#include "variants/opencl_device.hpp"
#include "variants/precisions.hpp"

namespace warpgrain {
namespace {

std::string lacks() {
  return count_opencl_devices() > 0 ? "" : "no OpenCL device: install a driver, such as pocl-opencl-icd";
}

std::unique_ptr<Simulation> create(const Scene& scene, const Variant& variant,
                                   const BackendOptions& options) {
  return std::make_unique<DeviceSimulation>(
      scene, variant, options, open_opencl_device(options.device, precision_of(variant).is_fp64));
}

}  // namespace

const Backend opencl_backend{"opencl", "any OpenCL device", lacks, create};

}  // namespace warpgrain
