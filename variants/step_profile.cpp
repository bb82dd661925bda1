#include "variants/step_profile.hpp"

#include "variants/device_simulation.hpp"
#include "variants/simt_device.hpp"

namespace warpgrain {

std::vector<profiler::LaunchProfile> profile_step(const Scene& scene, const Variant& variant,
                                                  const profiler::ProfileOptions& options,
                                                  const BackendOptions& backend) {
  const auto mode =
      options.addresses ? profiler::TraceMode::blocks_and_addresses : profiler::TraceMode::blocks;
  std::unique_ptr<SimtDevice> device = make_simt_device(mode, backend.threads);
  SimtDevice& simulator = *device;
  DeviceSimulation simulation(scene, variant, backend, std::move(device));
  simulator.record(options);
  simulation.step(1);
  return simulator.take_profiles();
}

}  // namespace warpgrain
