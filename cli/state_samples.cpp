#include "cli/state_samples.hpp"

#include <vector>

#include "core/candidate_census.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {

reports::StateSample sample_state(const Scene& scene, std::uint64_t step, const Variant& variant,
                                  profiler::ProfileOptions how, const BackendOptions& backend) {
  // The replay of machine code reads the paths of divisions among the addresses.
  how.addresses = how.weights.kind != profiler::WeightOptions::Kind::ptx;
  how.footprint = false;
  how.checks = profiler::Checks::off;
  how.what_if.clear();
  how.timelines = {};
  std::vector<profiler::LaunchCounters> launches;
  for (profiler::LaunchProfile& launch : profile_step(scene, variant, how, backend))
    launches.push_back(std::move(launch.counters));
  return reports::state_sample(step, static_cast<double>(step) * scene.time_step, candidate_census(scene),
                               launches);
}

}  // namespace warpgrain::cli
