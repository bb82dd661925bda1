#include "cli/measure_scene.hpp"

#include <algorithm>
#include <chrono>

#include "cli/interrupt.hpp"
#include "cli/modelled_parts.hpp"
#include "cli/output.hpp"
#include "cli/run_loop.hpp"
#include "variants/cuda_driver.hpp"

namespace warpgrain::cli {
namespace {

using Clock = std::chrono::steady_clock;

// False where Ctrl-C has come before the last step.
bool warm_up(Simulation& simulation, const SceneMeasurement& what, Progress& progress) {
  const std::uint64_t steps = what.at_step + what.warm_up;
  return !run_to_goal(
              simulation, {steps, {}, std::max<std::uint64_t>(1, steps)}, [](std::uint64_t) {}, progress)
              .interrupted;
}

void time_steps(Simulation& simulation, const SceneMeasurement& what, Progress& progress,
                reports::MeasuredReport::Step& step) {
  if (!warm_up(simulation, what, progress)) return;
  while (step.seconds.size() < what.repeats && !interrupted()) {
    const Clock::time_point begin = Clock::now();
    simulation.step(what.steps);
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    step.seconds.push_back(seconds / static_cast<double>(what.steps));
    progress.update("steps", static_cast<double>(step.seconds.size()) / what.repeats);
  }
}

// The kernels are those of the first reading.
void time_kernels(Simulation& simulation, const SceneMeasurement& what, Progress& progress,
                  std::vector<reports::MeasuredReport::Kernel>& kernels) {
  if (!warm_up(simulation, what, progress)) return;
  std::vector<KernelTiming> before = simulation.timings();
  for (std::size_t k = kernels.empty() ? 0 : kernels[0].seconds.size(); k < what.repeats && !interrupted();
       ++k) {
    simulation.step(1);
    const std::vector<KernelTiming> after = simulation.timings();
    for (std::size_t i = 0; i < after.size(); ++i) {
      const KernelTiming first = i < before.size() ? before[i] : KernelTiming{after[i].kernel, 0, 0};
      if (k == 0 && after[i].calls != first.calls) {
        kernels.emplace_back().kernel = after[i].kernel;
        kernels.back().calls = after[i].calls - first.calls;
      }
      const auto known = std::ranges::find_if(kernels, [&](const auto& kernel) {
        return kernel.kernel == after[i].kernel && kernel.seconds.size() == k;
      });
      if (known != kernels.end()) known->seconds.push_back(after[i].seconds - first.seconds);
    }
    before = after;
    progress.update("kernels", static_cast<double>(k + 1) / what.repeats);
  }
}

// A profiler slows every launch that it sees: nothing runs but the way to the step and the step.
void mark_step(Simulation& simulation, const SceneMeasurement& what) {
  simulation.step(what.at_step + what.warm_up);
  const CudaProfilerRange range;
  simulation.step(1);
}

}  // namespace

reports::MeasuredReport measure_scene(const Scene& scene, const Variant& variant,
                                      const SceneMeasurement& what, const reports::MeasuredReport* earlier,
                                      Progress& progress) {
  const Backend& chosen = backend(what.backend);
  reports::MeasuredReport report;
  report.generator = reports::this_generator();
  report.command_line = command_line();
  report.backend = chosen.name;
  report.scene = scene.name;
  report.variant = variant.name();
  report.model = modelled_parts(scene, variant, what.backend);
  report.particles = scene.particles.size();
  report.seed = scene.seed;
  report.step =
      earlier != nullptr && earlier->step ? *earlier->step : reports::MeasuredReport::Step{what.steps, {}};
  if (earlier != nullptr) report.kernels = earlier->kernels;
  BackendOptions untimed = what.options;
  untimed.kernel_times = BackendOptions::KernelTimes::none;
  {
    const auto simulation = chosen.create(scene, variant, untimed);
    report.device = {simulation->device(), "", simulation->driver()};
    if (what.mark) {
      mark_step(*simulation, what);
      report.step.reset();
      return report;
    }
    if (report.step->seconds.size() < what.repeats) time_steps(*simulation, what, progress, *report.step);
  }
  if (report.step->seconds.empty()) throw Interrupted();
  BackendOptions timed = what.options;
  timed.kernel_times = BackendOptions::KernelTimes::undisturbed;
  const auto simulation = chosen.create(scene, variant, timed);
  time_kernels(*simulation, what, progress, report.kernels);
  progress.clear();
  return report;
}

}  // namespace warpgrain::cli
