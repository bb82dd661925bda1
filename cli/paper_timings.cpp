#include "cli/paper_timings.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <string_view>

#include "cli/step_timing.hpp"
#include "core/error.hpp"
#include "reports/run_report.hpp"

namespace warpgrain::cli {

Variant paper_variant(bool practical) {
  Variant variant;
  variant.set("model", "full");
  variant.set("contact", practical ? "branchy" : "simple");
  return variant;
}

std::vector<reports::PaperTiming> timings_here(const Scene& scene, const BackendOptions& options,
                                               std::uint64_t steps, Progress& progress) {
  struct Wanted {
    bool practical;
    std::string_view backend;
  };
  std::vector<reports::PaperTiming> timings;
  for (const Wanted& wanted : {Wanted{false, "cuda"}, {false, "opencl"}, {true, "opencl"}, {true, "host"}}) {
    const auto all = backends();
    const auto found = std::ranges::find(all, wanted.backend, &Backend::name);
    if (found == all.end() || !found->lacks().empty()) continue;
    progress.update(fmt::format("timing {}", wanted.backend), 0);
    BackendOptions how = options;
    if (wanted.backend == "host") how.threads = 1;
    const auto simulation = found->create(scene, paper_variant(wanted.practical), how);
    const double seconds = median_seconds_per_step(*simulation, steps);
    timings.push_back(
        {wanted.practical, std::string(wanted.backend), static_cast<double>(scene.particles.size()) / seconds,
         fmt::format("here: {}{}", simulation->device(), wanted.backend == "host" ? ", 1 thread" : "")});
  }
  return timings;
}

reports::PaperTiming timing_from(const std::string& file) {
  const reports::RunReport run = reports::read_run(file);
  if (run.steps == 0) throw_input_error(file, "a run of no steps", "a run that took time");
  const Variant variant = Variant::parse(run.variant);
  return {variant.value(AxisId::contact) != "simple", run.backend, run.particle_steps_per_second(),
          fmt::format("{}: {}, {} of {} particles, {} steps", std::filesystem::path(file).filename().string(),
                      run.device, run.scene, run.particles, run.steps)};
}

}  // namespace warpgrain::cli
