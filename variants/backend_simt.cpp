#include "variants/backend_simt.hpp"

#include "variants/device_simulation.hpp"
#include "variants/simt_device.hpp"

namespace warpgrain {
namespace {

std::unique_ptr<Simulation> create(const Scene& scene, const Variant& variant,
                                   const BackendOptions& options) {
  return std::make_unique<DeviceSimulation>(
      scene, variant, options,
      make_simt_device(profiler::TraceMode::none, options.threads, options.compiler));
}

}  // namespace

const Backend simt_backend{"simt", "the SIMT simulator, without counting", simulator_lacks, create};

}  // namespace warpgrain
