#include "cli/measure_scene.hpp"

#include <algorithm>
#include <chrono>

#include "cli/modelled_parts.hpp"
#include "cli/output.hpp"
#include "variants/cuda_driver.hpp"

namespace warpgrain::cli {
namespace {

using Clock = std::chrono::steady_clock;

reports::MeasuredReport::Step time_steps(Simulation& simulation, const SceneMeasurement& what,
                                         Progress& progress) {
  reports::MeasuredReport::Step step{what.steps, {}};
  simulation.step(what.at_step + what.warm_up);
  for (unsigned k = 0; k < what.repeats; ++k) {
    const Clock::time_point begin = Clock::now();
    simulation.step(what.steps);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    step.seconds.push_back(seconds / static_cast<double>(what.steps));
    progress.update("steps", static_cast<double>(k + 1) / what.repeats);
  }
  return step;
}

std::vector<reports::MeasuredReport::Kernel> time_kernels(Simulation& simulation,
                                                          const SceneMeasurement& what, Progress& progress) {
  std::vector<reports::MeasuredReport::Kernel> kernels;
  simulation.step(what.at_step + what.warm_up);
  std::vector<KernelTiming> before = simulation.timings();
  for (unsigned k = 0; k < what.repeats; ++k) {
    simulation.step(1);
    const std::vector<KernelTiming> after = simulation.timings();
    for (std::size_t i = 0; i < after.size(); ++i) {
      const KernelTiming first = i < before.size() ? before[i] : KernelTiming{after[i].kernel, 0, 0};
      if (k == 0) {
        kernels.emplace_back().kernel = after[i].kernel;
        kernels[i].calls = after[i].calls - first.calls;
      }
      kernels[i].seconds.push_back(after[i].seconds - first.seconds);
    }
    before = after;
    progress.update("kernels", static_cast<double>(k + 1) / what.repeats);
  }
  std::erase_if(kernels, [](const auto& kernel) { return kernel.calls == 0; });
  return kernels;
}

}  // namespace

reports::MeasuredReport measure_scene(const Scene& scene, const Variant& variant,
                                      const SceneMeasurement& what, Progress& progress) {
  const Backend& chosen = backend(what.backend);
  reports::MeasuredReport report;
  report.generator = reports::this_generator();
  report.command_line = command_line();
  report.backend = chosen.name;
  report.scene = scene.name;
  report.variant = variant.name();
  report.model = modelled_parts(scene, variant, what.backend);
  report.particles = scene.particles.size();
  {
    BackendOptions untimed = what.options;
    untimed.kernel_times = BackendOptions::KernelTimes::none;
    const auto simulation = chosen.create(scene, variant, untimed);
    report.device = {simulation->device(), "", simulation->driver()};
    report.step = time_steps(*simulation, what, progress);
  }
  BackendOptions timed = what.options;
  timed.kernel_times = BackendOptions::KernelTimes::undisturbed;
  const auto simulation = chosen.create(scene, variant, timed);
  report.kernels = time_kernels(*simulation, what, progress);
  if (what.mark) {
    const CudaProfilerRange range;
    simulation->step(1);
  }
  progress.clear();
  return report;
}

}  // namespace warpgrain::cli
