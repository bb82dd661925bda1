#include "cli/accuracy/cost_level.hpp"

#include "cli/step_timing.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {

StepCost cost_of(const AccuracySetting& setting, const Variant& variant) {
  profiler::ProfileOptions options;
  options.checks = profiler::Checks::off;
  options.threads = setting.backend.threads;
  StepCost cost;
  for (const auto& launch : profile_step(setting.at_step, variant, options, setting.backend)) {
    const profiler::Totals& totals = launch.counters.totals;
    cost.warp_instructions += totals.warp_instructions;
    cost.bytes += 32 * (totals.global_load.sectors + totals.global_store.sectors + totals.atomic.sectors);
  }
  if (setting.timed_steps > 0 && backend("opencl").lacks().empty())
    cost.seconds = median_seconds_per_step(
        *backend("opencl").create(setting.at_step, variant, setting.backend), setting.timed_steps);
  return cost;
}

}  // namespace warpgrain::cli
