#include "variants/backend_simt.hpp"

#include "variants/device_simulation.hpp"
#include "variants/simt_device.hpp"

namespace warpgrain {
namespace {

template <Approximations approximations>
std::unique_ptr<Simulation> create(const Scene& scene, const Variant& variant,
                                   const BackendOptions& options) {
  return std::make_unique<DeviceSimulation>(
      scene, variant, options,
      make_simt_device(profiler::TraceMode::none, options.threads, options.compiler, profiler::Checks::off,
                       approximations));
}

}  // namespace

const Backend simt_backend{"simt", "the SIMT simulator, without counting", simulator_lacks,
                           create<Approximations::exact>};
const Backend simt_approximate_backend{
    "simt_approximate", "the SIMT simulator, approximate functions as far off as the PTX ISA allows",
    simulator_lacks, create<Approximations::as_far_off_as_allowed>};

}  // namespace warpgrain
