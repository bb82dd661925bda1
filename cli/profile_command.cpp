// `warpgrain profile`: the divergence report of a launch file, or of one time step of a scene.

#include <filesystem>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cli/app.hpp"
#include "cli/bed.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/list_making_of.hpp"
#include "cli/modelled_parts.hpp"
#include "cli/output.hpp"
#include "cli/profile_options.hpp"
#include "cli/run_loop.hpp"
#include "cli/state_samples.hpp"
#include "core/error.hpp"
#include "profiler/launch_export.hpp"
#include "reports/diagnostic_summary.hpp"
#include "reports/html/report_page.hpp"
#include "reports/ptx_files.hpp"
#include "reports/report_json.hpp"
#include "reports/text_report.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {
namespace {

struct Options {
  std::string launch;
  std::string build_options;
  SceneOptions scene;
  VariantOptions variant;
  DeviceOptions device;
  SimulatorOptions simulator;
  OutputOptions output;
  std::uint64_t at_step = 0, sample_every = 0, bed = default_bed_particles;
  bool until_rest = false;
  std::string html;
  std::string export_folder;
  bool against_full = false;
};

// The PTX goes beside the JSON.
reports::Report report_of(std::span<const profiler::LaunchProfile> launches, const Options& options,
                          const profiler::ProfileOptions& how) {
  require_timelines(how.timelines, launches);
  reports::Report report = reports::make_report(launches, command_line());
  const std::string& json = options.output.json;
  if (!json.empty() && json != "-") reports::keep_ptx(report, launches, json);
  return report;
}

reports::Report profile_launch_file(const Options& options, const profiler::ProfileOptions& how) {
  const profiler::LaunchFile file = profiler::read_launch_file(options.launch);
  if (!options.export_folder.empty())
    export_launch(file, profiler::load_launch(file, options.build_options), options.export_folder);
  const auto result = profiler::profile_launch_file(file, options.build_options, how, std::cout);
  return report_of(std::span(&result.profile, 1), options, how);
}

// Where the profiled step begins, and the states on the way there that were asked for.
struct ReachedState {
  Scene scene;
  std::uint64_t step = 0;
  std::vector<reports::StateSample> samples;
};

ReachedState state_to_profile(const Scene& scene, const Variant& variant, const Options& options,
                              const profiler::ProfileOptions& how, Progress& progress) {
  const BackendOptions backend = options.device.backend_options();
  if (!options.until_rest && options.sample_every == 0)
    return {advanced(scene, variant, backend, options.at_step, progress), options.at_step, {}};
  RunGoal goal{options.at_step, {}, options.sample_every};
  if (options.until_rest) goal = {{}, rest_of(scene), options.sample_every};
  ReachedState reached{scene, 0, {}};
  reached.step = advance(reached.scene, variant, backend, goal, progress, [&](std::uint64_t step) {
                   if (options.sample_every != 0)
                     reached.samples.push_back(sample_state(reached.scene, step, variant, how, backend));
                 }).steps;
  return reached;
}

reports::Report profile_scene(const Options& options, const std::optional<Machine>& machine,
                              const profiler::ProfileOptions& how, Progress& progress) {
  const Scene scene = options.scene.load();
  const Variant variant = options.variant.resolve(scene, options.device.kernels);
  const ReachedState reached = state_to_profile(scene, variant, options, how, progress);
  const Scene& at_step = reached.scene;
  ProfiledState left;
  const auto launches =
      profile_step(at_step, variant, how, options.device.backend_options(), options.export_folder, &left);
  reports::Report report = report_of(launches, options, how);
  report.list_making = list_making_of(launches, left, machine);
  report.bed = bed_of(at_step, variant, launches, left, options.bed);
  report.scene = scene.name;
  report.variant = variant.name();
  report.model = modelled_parts(at_step, variant, "simt");
  if (options.against_full)
    report.model.against_full = profile_savings(
        at_step, variant, launches,
        profile_step(at_step, with_full_model(variant), how, options.device.backend_options()));
  report.particles = scene.particles.size();
  report.seed = scene.seed;
  report.step = reached.step;
  report.samples = reached.samples;
  return report;
}

int profile(const Options& options) {
  Progress progress(options.output.quiet);
  const profiler::ProfileOptions how = options.simulator.profile_options(options.device, progress);
  if (options.launch.empty() == options.scene.scene.empty())
    throw_input_error("warpgrain profile",
                      options.launch.empty() ? "nothing to profile" : "both a launch file and --scene",
                      "either a launch file (.sim) or --scene FILE|NAME");
  if (options.against_full && options.scene.scene.empty())
    throw_input_error("--against-full", "a launch file",
                      "a scene: the model is that of the built-in kernels");
  if (options.sample_every != 0 && options.at_step == 0 && !options.until_rest)
    throw_input_error("--sample-every", "no steps to sample on the way", "--at-step or --until-rest");
  if (!options.export_folder.empty()) make_folder(options.export_folder);
  const auto machine = options.simulator.load_machine();  // before the run: a wrong name costs nothing
  reports::Report report = options.launch.empty() ? profile_scene(options, machine, how, progress)
                                                  : profile_launch_file(options, how);
  report.machine = machine;
  progress.clear();
  if (!options.output.json.empty()) write_output(options.output.json, reports::report_json(report));
  if (!options.html.empty()) write_output(options.html, reports::report_page(report));
  if (options.output.summary()) std::cout << reports::text_report(report);
  const std::vector<std::string> diagnostics = reports::diagnostic_lines(report);
  if (!options.output.summary())
    for (const std::string& line : diagnostics) std::cerr << line << '\n';
  return diagnostics.empty() ? 0 : 1;
}

}  // namespace

void add_profile_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand("profile", help_text().summary("profile"));
  add_option(command, "launch", options->launch);
  add_option(command, "--build-options", options->build_options);
  options->scene.add_to(command);
  CLI::Option* at_step = add_option(command, "--at-step", options->at_step);
  add_flag(command, "--until-rest", options->until_rest)->excludes(at_step);
  add_option(command, "--sample-every", options->sample_every);
  add_option(command, "--bed", options->bed);
  add_output_file(command, "--html", options->html);
  add_option(command, "--export", options->export_folder);
  add_flag(command, "--against-full", options->against_full);
  options->simulator.add_to(command);
  options->variant.add_to(command);
  options->device.add_to(command);
  options->output.add_to(command);
  command.callback([options, &chosen] { chosen = [options] { return profile(*options); }; });
}

}  // namespace warpgrain::cli
