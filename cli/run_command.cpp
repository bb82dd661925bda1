// `warpgrain run`: simulates a scene; timings, energies, contacts, the final state.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "cli/app.hpp"
#include "cli/checkpoint.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/interrupt.hpp"
#include "cli/modelled_parts.hpp"
#include "cli/output.hpp"
#include "cli/run_loop.hpp"
#include "core/run_monitor.hpp"
#include "core/state_file.hpp"
#include "core/time_step_advice.hpp"
#include "reports/run_report.hpp"
#include "reports/text_run.hpp"
#include "reports/vtk_file.hpp"
#include "variants/contact_laws.hpp"
#include "variants/step_arithmetic.hpp"

namespace warpgrain::cli {
namespace {

struct RunOptions {
  SceneOptions scene;
  VariantOptions variant;
  DeviceOptions device;
  OutputOptions output;
  std::string backend = "opencl";
  std::optional<std::uint64_t> steps;
  bool until_rest = false;
  bool against_full = false;
  std::uint64_t sample_every = 0;
  std::string state_file, vtk_folder, checkpoint;
  bool resume = false;
};

RunGoal requested_goal(const RunOptions& options, const Scene& scene) {
  RunGoal goal = goal_of(scene);
  if (options.steps) goal = {options.steps, {}, 0};
  if (options.until_rest) goal = {{}, rest_of(scene), 0};
  goal.sample_every = options.sample_every;
  return goal;
}

void add_kernels(std::vector<reports::RunReport::Kernel>& kernels, const std::vector<KernelTiming>& timings) {
  for (const KernelTiming& timing : timings) {
    const auto found = std::find_if(kernels.begin(), kernels.end(),
                                    [&](const auto& kernel) { return kernel.name == timing.kernel; });
    if (found == kernels.end()) {
      kernels.push_back({timing.kernel, timing.calls, timing.seconds});
    } else {
      found->calls += timing.calls;
      found->seconds += timing.seconds;
    }
  }
}

// The same steps with the full model: how long they take, and where the particles are in the end.
void run_full_model(const Scene& scene, const Variant& variant, const RunOptions& options,
                    const Simulation& simulation, reports::RunReport& report) {
  const auto full =
      backend(options.backend)
          .create(scene, with_full_model(variant), options.device.backend_options(options.backend));
  const auto begin = std::chrono::steady_clock::now();
  full->step(report.steps);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const auto steps = static_cast<double>(report.steps);
  report.model.against_full.push_back({"seconds a step", report.wall_seconds / steps, seconds / steps});
  if (report.model.device_bytes_per_particle)
    report.model.against_full.push_back(memory_saving(scene, variant));
  const ParticleState here = simulation.state(), there = full->state();
  double farthest = 0;
  for (std::size_t k = 0; k < here.size(); ++k)
    farthest = std::max(farthest, (here.position[k] - there.position[k]).norm());
  report.model.position_difference = farthest;
}

int run(const RunOptions& options) {
  const Backend& chosen_backend = backend(options.backend);
  Scene scene = options.scene.load();
  const Variant variant = options.variant.resolve(scene, options.device.kernels);
  scene.model.contact = contact_law(variant).model;  // whose energies are reported
  const TimeStepLimits limits = time_step_limits(scene);
  std::optional<TimeStepAdvice> advice;
  if (scene.time_step_is_auto) {
    advice = advise_time_step(scene, limits, step_arithmetic(scene, variant));
    scene.time_step = advice->step;
    if (!advice->is_right) warn_of({advice->reason});
  }
  if (const std::string warning = time_step_warning(scene.time_step, limits); !warning.empty())
    warn_of({warning});
  if (!options.vtk_folder.empty()) make_folder(options.vtk_folder);
  if (!options.checkpoint.empty()) make_folder(options.checkpoint);

  reports::RunReport report;
  report.generator = reports::this_generator();
  report.command_line = command_line();
  report.scene = scene.name;
  report.variant = variant.name();
  report.backend = chosen_backend.name;
  report.model = modelled_parts(scene, variant, chosen_backend.name);
  report.particles = scene.particles.size();
  report.seed = scene.seed;
  report.time_step = scene.time_step;
  if (options.resume) {
    const reports::RunReport earlier = read_checkpoint(options.checkpoint, report, scene);
    report.steps = earlier.steps;
    report.wall_seconds = earlier.wall_seconds;
    report.kernels = earlier.kernels;
    report.energy = earlier.energy;
  }
  RunGoal goal = requested_goal(options, scene);
  goal.begin = report.steps;
  const auto simulation =
      chosen_backend.create(scene, variant, options.device.backend_options(chosen_backend.name));
  report.device = simulation->device();

  RunMonitor monitor(scene);
  const auto sample = [&](std::uint64_t step) {
    const ParticleState state = simulation->state();
    warn_of(monitor.look(step, state));
    if (!report.energy.empty() && report.energy.back().step == step) return;  // the checkpoint's last
    const Energy& energy = monitor.energy();
    report.energy.push_back({step, static_cast<double>(step) * scene.time_step, energy.kinetic_translational,
                             energy.kinetic_rotational, energy.gravitational,
                             energy.elastic_normal + energy.elastic_tangential});
    if (options.vtk_folder.empty()) return;
    const std::filesystem::path folder = options.vtk_folder;
    reports::write_vtk_contacts(folder / fmt::format("contacts_{:09}.vtp", step), scene, state);
    reports::write_vtk_particles(folder / fmt::format("particles_{:09}.vtp", step), state);
  };
  Progress progress(options.output.quiet);
  const InterruptWatch watch;
  const RunOutcome outcome = run_to_goal(*simulation, goal, sample, progress);
  progress.clear();

  report.steps = outcome.steps;
  report.wall_seconds += outcome.wall_seconds;
  report.ended_by = outcome.interrupted                ? reports::RunEndReason::interrupted
                    : outcome.at_rest                  ? reports::RunEndReason::at_rest
                    : scene.end.time && !options.steps ? reports::RunEndReason::time
                                                       : reports::RunEndReason::steps;
  report.contacts = simulation->contact_count();
  add_kernels(report.kernels, simulation->timings());

  if (options.against_full && report.steps > 0 && !outcome.interrupted)
    run_full_model(scene, variant, options, *simulation, report);

  if (!options.checkpoint.empty()) write_checkpoint(options.checkpoint, report, simulation->state());
  if (!options.state_file.empty()) write_output(options.state_file, format_state_csv(simulation->state()));
  if (!options.output.json.empty()) write_output(options.output.json, reports::run_json(report));
  if (options.output.summary() && options.state_file != "-")
    std::cout
        << reports::text_run(report)
        << fmt::format(
               "\ntime step {:.3g} s{}; Rayleigh time {:.3g} s, Hertz contact time {:.3g} s at {:.3g} m/s\n",
               scene.time_step, advice ? ", " + advice->reason : std::string(), limits.rayleigh_time,
               limits.hertz_contact_time, limits.impact_speed);
  if (!outcome.interrupted) return 0;
  return say_interrupted("run", fmt::format("at step {}", report.steps), options.checkpoint);
}

}  // namespace

void add_run_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<RunOptions>();
  CLI::App& command = *app.add_subcommand("run", help_text().summary("run"));
  options->scene.add_to(command)->required();
  add_option(command, "--backend", options->backend);
  CLI::Option* steps = add_option(command, "--steps", options->steps);
  add_flag(command, "--until-rest", options->until_rest)->excludes(steps);
  add_option(command, "--sample-every", options->sample_every);
  CLI::Option* against_full = add_flag(command, "--against-full", options->against_full);
  add_output_file(command, "--state", options->state_file);
  add_option(command, "--vtk", options->vtk_folder);
  CLI::Option* checkpoint = add_option(command, "--checkpoint", options->checkpoint);
  add_flag(command, "--resume", options->resume)->needs(checkpoint)->excludes(against_full);
  options->variant.add_to(command);
  options->device.add_to(command);
  options->device.add_keeping_to(command);
  options->output.add_to(command);
  command.callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace warpgrain::cli
