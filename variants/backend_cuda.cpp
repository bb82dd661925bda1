#include "variants/backend_cuda.hpp"

#include "variants/cuda_compute_device.hpp"
#include "variants/device_simulation.hpp"

namespace warpgrain {
namespace {

std::unique_ptr<Simulation> create(const Scene& scene, const Variant& variant,
                                   const BackendOptions& options) {
  return std::make_unique<DeviceSimulation>(scene, variant, options, open_cuda_device(options));
}

}  // namespace

const Backend cuda_backend{"cuda",
                           "a CUDA device, running the PTX that the simulator runs, or another compiler's",
                           cuda_device_lacks, create};

}  // namespace warpgrain
