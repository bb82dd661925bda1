#include "cli/modelled_parts.hpp"

#include <functional>

#include "variants/device_scene.hpp"
#include "variants/scene_features.hpp"

namespace warpgrain::cli {
namespace {

double device_bytes_per_particle(const Scene& scene, const Variant& variant) {
  return static_cast<double>(device_bytes(lay_out(scene, variant))) /
         static_cast<double>(scene.particles.size());
}

}  // namespace

reports::ModelledParts modelled_parts(const Scene& scene, const Variant& variant, std::string_view backend) {
  const bool is_host = backend == "host";
  reports::ModelledParts parts;
  const SceneFeatures features = features_of(scene, variant);
  for (const Feature& row : features.rows())
    parts.features.push_back({std::string(row.name), row.is_needed, row.is_modelled || is_host, row.why});
  if (!is_host) parts.device_bytes_per_particle = device_bytes_per_particle(scene, variant);
  return parts;
}

Variant with_full_model(Variant variant) {
  variant.set("model", "full");
  return variant;
}

reports::Saving memory_saving(const Scene& scene, const Variant& variant) {
  return {"bytes of device memory a particle", device_bytes_per_particle(scene, variant),
          device_bytes_per_particle(scene, with_full_model(variant))};
}

std::vector<reports::Saving> profile_savings(const Scene& scene, const Variant& variant,
                                             std::span<const profiler::LaunchProfile> launches,
                                             std::span<const profiler::LaunchProfile> of_full_model) {
  using Quantity = std::function<double(const profiler::Totals&)>;
  const auto saving = [&](const char* name, const Quantity& quantity) {
    const auto a_particle = [&](std::span<const profiler::LaunchProfile> profiles) {
      double sum = 0;
      for (const profiler::LaunchProfile& launch : profiles) sum += quantity(launch.counters.totals);
      return sum / static_cast<double>(scene.particles.size());
    };
    return reports::Saving{name, a_particle(launches), a_particle(of_full_model)};
  };
  const auto count = [](auto number) { return static_cast<double>(number); };
  return {memory_saving(scene, variant),
          saving("bytes moved a particle and step",
                 [&](const profiler::Totals& t) {
                   return 32 * count(t.global_load.sectors + t.global_store.sectors);
                 }),
          saving("warp instructions a particle and step",
                 [&](const profiler::Totals& t) { return count(t.warp_instructions); }),
          saving("SFU instructions a particle and step",
                 [&](const profiler::Totals& t) { return count(t.sfu_instructions); })};
}

}  // namespace warpgrain::cli
