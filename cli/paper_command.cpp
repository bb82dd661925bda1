// `warpgrain paper`: the paper's tables and figures beside what is computed, simulated and measured.

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "cli/app.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/output.hpp"
#include "cli/paper_variants.hpp"
#include "cli/progress.hpp"
#include "cli/run_loop.hpp"
#include "cli/step_timing.hpp"
#include "cli/sweep_plan.hpp"
#include "core/candidate_census.hpp"
#include "core/contact_history.hpp"
#include "core/error.hpp"
#include "profiler/observers/path_census.hpp"
#include "reports/document_format.hpp"
#include "reports/html/paper_page.hpp"
#include "reports/measured_report.hpp"
#include "reports/paper_rows.hpp"
#include "reports/run_report.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {
namespace {

constexpr std::string_view paper_machine = "fermi_c2050";
// The paper has eight times as many.
constexpr std::uint64_t default_particles = 16384;

struct Options {
  SceneOptions scene;
  DeviceOptions device;
  OutputOptions output;
  std::uint64_t steps = 20000;
  std::uint64_t samples = 4;
  std::uint64_t timed_steps = 20;
  bool until_rest = false;
  std::string machine = "hopper_h100", html;
  std::vector<std::string> measured;
  std::vector<std::string> axis;
};

// The paper's kernels compute all of the model, whatever the scene.
Variant variant_of(bool practical) {
  Variant variant;
  variant.set("model", "full");
  variant.set("contact", practical ? "branchy" : "simple");
  return variant;
}

// The step of one model at this state; `observer` may be null.
std::vector<profiler::LaunchCounters> profiled(const Scene& scene, bool practical, const Options& options,
                                               profiler::WarpObserver* observer) {
  profiler::ProfileOptions how;
  how.addresses = false;
  how.checks = profiler::Checks::off;
  how.threads = options.device.threads;
  how.observer = observer;
  std::vector<profiler::LaunchCounters> launches;
  for (profiler::LaunchProfile& launch :
       profile_step(scene, variant_of(practical), how, options.device.backend_options()))
    launches.push_back(std::move(launch.counters));
  return launches;
}

reports::PaperReport::Sample sample_of(const Scene& scene, std::uint64_t step,
                                       const std::vector<profiler::LaunchCounters>& launches) {
  reports::PaperReport::Sample sample;
  sample.step = step;
  sample.time = static_cast<double>(step) * scene.time_step;
  const CandidateCensus census = candidate_census(scene);
  sample.mean_candidates = census.mean_candidates;
  sample.most_candidates = census.most_candidates;
  sample.mean_contacts = census.mean_contacts;
  sample.most_contacts = census.most_contacts;
  struct Sum {
    std::string kernel;
    profiler::Totals totals;
  };
  std::vector<Sum> sums;
  for (const profiler::LaunchCounters& launch : launches) {
    const auto known = std::ranges::find(sums, launch.kernel, &Sum::kernel);
    if (known == sums.end())
      sums.push_back({launch.kernel, launch.totals});
    else
      known->totals.add(launch.totals);
  }
  std::ranges::stable_sort(sums, std::greater(), [](const Sum& sum) { return sum.totals.warp_instructions; });
  for (const Sum& sum : sums)
    sample.kernels.push_back(
        {sum.kernel, sum.totals.warp_instructions, sum.totals.simt_efficiency(launches.front().warp_width)});
  return sample;
}

std::vector<reports::PaperReport::Paths> paths_of(profiler::PathCensus& census, const std::string& kernel) {
  std::vector<profiler::LoopPaths> bodies = census.bodies();
  std::erase_if(bodies, [&](const profiler::LoopPaths& body) { return body.kernel != kernel; });
  double all = 0;
  for (const profiler::LoopPaths& body : bodies) all += static_cast<double>(body.instructions);
  std::ranges::stable_sort(bodies, std::greater(), &profiler::LoopPaths::instructions);
  std::vector<reports::PaperReport::Paths> paths;
  for (const profiler::LoopPaths& body : bodies)
    paths.push_back({body.kernel, body.file, body.line, body.branches, body.passes, body.paths,
                     static_cast<double>(body.instructions) / all});
  return paths;
}

// On this machine, at this state: both models on OpenCL, the practical one in C++ on one core, the simple one
// with CUDA where there is that back end and a device.
std::vector<reports::PaperTiming> timings_here(const Scene& scene, const Options& options,
                                               Progress& progress) {
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
    BackendOptions how = options.device.backend_options();
    if (wanted.backend == "host") how.threads = 1;
    const auto simulation = found->create(scene, variant_of(wanted.practical), how);
    const double seconds = median_seconds_per_step(*simulation, options.timed_steps);
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

// Samples from falling on; the last state is where everything else is counted and timed.
Scene sample_the_fall(const Options& options, reports::PaperReport& report, Progress& progress) {
  SceneOptions chosen = options.scene;
  if (chosen.scene.empty()) {
    chosen.scene = "slit";
    if (!chosen.particles) chosen.particles = default_particles;
  }
  Scene scene = chosen.load();
  const std::unique_ptr<Simulation> simulation =
      backend("opencl").create(scene, variant_of(true), options.device.backend_options());
  RunGoal goal{options.steps, {}, std::max<std::uint64_t>(1, options.steps / options.samples)};
  if (options.until_rest) {
    goal = {{}, rest_of(scene), 0};
  }
  run_to_goal(
      *simulation, goal,
      [&] {
        scene.particles = simulation->state();
        make_antisymmetric(scene.particles.contact_history);
        report.samples.push_back(
            sample_of(scene, simulation->steps_done(), profiled(scene, true, options, nullptr)));
      },
      progress);
  return scene;
}

int paper(const Options& options) {
  if (options.samples == 0) throw_input_error("--samples", "0", "a number above 0");
  reports::PaperFacts facts;
  facts.paper_machine = load_machine(paper_machine);
  facts.machine = load_machine(options.machine);
  const std::vector<Variant> variants = swept_variants(options.axis);
  std::vector<std::string> measured_steps;
  for (const std::string& file : options.measured)
    if (reports::format_of(file) == reports::measured_format)
      measured_steps.push_back(file);
    else
      facts.timings.push_back(timing_from(file));

  Progress progress(options.output.quiet);
  reports::PaperReport report;
  report.generator = reports::this_generator();
  report.command_line = command_line();
  const Scene scene = sample_the_fall(options, report, progress);
  report.scene = scene.name;
  report.particles = facts.particles = scene.particles.size();

  progress.update("simulating", 0);
  profiler::PathCensus census;
  facts.practical = {32, profiled(scene, true, options, &census)};
  facts.simple = {32, profiled(scene, false, options, nullptr)};
  report.paths = paths_of(census, facts.practical.forces().kernel);
  const auto here = timings_here(scene, options, progress);
  facts.timings.insert(facts.timings.begin(), here.begin(), here.end());
  reports::add_paper_rows(report, facts);
  std::vector<Machine> machines{facts.paper_machine};
  if (facts.machine->name != facts.paper_machine.name) machines.push_back(*facts.machine);
  const auto rows = variant_rows(scene, variants, machines, options.device.backend_options(),
                                 MeasuredSteps(measured_steps), progress);
  report.rows.insert(report.rows.end(), rows.begin(), rows.end());
  progress.clear();
  if (!options.output.json.empty()) write_output(options.output.json, reports::paper_json(report));
  if (!options.html.empty()) write_output(options.html, reports::paper_page(report));
  if (options.output.summary() && options.html != "-") std::cout << reports::text_paper(report);
  return 0;
}

}  // namespace

void add_paper_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand("paper", help_text().summary("paper"));
  options->scene.add_to(command);
  CLI::Option* steps = add_option(command, "--steps", options->steps);
  add_flag(command, "--until-rest", options->until_rest)->excludes(steps);
  add_option(command, "--samples", options->samples);
  add_option(command, "--timed-steps", options->timed_steps);
  add_option(command, "--measured", options->measured);
  add_option(command, "--machine", options->machine);
  add_option(command, "--axis", options->axis);
  add_output_file(command, "--html", options->html);
  options->device.add_to(command);
  options->output.add_to(command);
  command.callback([options, &chosen] { chosen = [options] { return paper(*options); }; });
}

}  // namespace warpgrain::cli
