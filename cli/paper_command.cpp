// `warpgrain paper`: the paper's tables and figures beside what is computed, simulated and measured.

#include <algorithm>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "cli/app.hpp"
#include "cli/checkpoint.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/paper_timings.hpp"
#include "cli/paper_variants.hpp"
#include "cli/progress.hpp"
#include "cli/run_loop.hpp"
#include "cli/state_samples.hpp"
#include "cli/sweep_plan.hpp"
#include "core/error.hpp"
#include "profiler/observers/path_census.hpp"
#include "reports/document_format.hpp"
#include "reports/html/paper_page.hpp"
#include "reports/measured_report.hpp"
#include "reports/paper_rows.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {
namespace {

constexpr std::string_view paper_machine = "fermi_c2050";
// The paper has eight times as many.
constexpr std::uint64_t paper_particles = 16384;

struct PaperOptions {
  SceneOptions scene;
  DeviceOptions device;
  OutputOptions output;
  std::uint64_t steps = 20000;
  std::uint64_t samples = 4;
  std::uint64_t timed_steps = 20;
  bool until_rest = false, resume = false;
  std::string machine = "hopper_h100", html, checkpoint;
  std::vector<std::string> measured;
  std::vector<std::string> axis;
};

Scene scene_of(const PaperOptions& options) {
  SceneOptions chosen = options.scene;
  if (chosen.scene.empty()) {
    chosen.scene = "slit";
    if (!chosen.particles) chosen.particles = paper_particles;
  }
  return chosen.load();
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

// Goes through what the paper has, part by part. Each is done when it returns true; else Ctrl-C has come.
class PaperStudy {
 public:
  explicit PaperStudy(const PaperOptions& options) : options_(options), progress_(options.output.quiet) {
    facts_.paper_machine = load_machine(paper_machine);
    facts_.machine = load_machine(options.machine);
    variants_ = swept_variants(options.axis);
    for (const std::string& file : options.measured)
      if (reports::format_of(file) == reports::measured_format)
        measured_steps_.push_back(file);
      else
        facts_.timings.push_back(timing_from(file));
    scene_ = scene_of(options);
    how_.addresses = false;
    how_.checks = profiler::Checks::off;
    how_.threads = options.device.threads;
    report_.generator = reports::this_generator();
    report_.command_line = command_line();
    report_.scene = scene_.name;
    report_.particles = facts_.particles = scene_.particles.size();
    report_.seed = scene_.seed;
    report_.fall_is_over = false;
  }

  // What an earlier call has kept.
  void resume() {
    reports::PaperReport earlier = reports::read_paper(options_.output.json);
    require_same_call(options_.output.json, earlier.command_line);
    read_particles(options_.checkpoint, scene_);
    report_.fall_steps = earlier.fall_steps;
    report_.fall_is_over = earlier.fall_is_over;
    report_.samples = std::move(earlier.samples);
    report_.paths = std::move(earlier.paths);
    earlier_rows_ = std::move(earlier.rows);
  }

  // Samples from falling on; the last state is where everything else is counted and timed.
  bool fall() {
    if (!report_.fall_is_over) {
      RunGoal goal{options_.steps, {}, std::max<std::uint64_t>(1, options_.steps / options_.samples)};
      if (options_.until_rest) goal = {{}, rest_of(scene_), 0};
      goal.begin = report_.fall_steps;
      const RunOutcome outcome = advance(scene_, paper_variant(true), options_.device.backend_options(), goal,
                                         progress_, [&](std::uint64_t step) {
                                           if (!interrupted()) sample(step);
                                         });
      report_.fall_steps = outcome.steps;
      report_.fall_is_over = !outcome.interrupted;
    }
    if (report_.fall_is_over && !interrupted()) sample(report_.fall_steps);
    return report_.fall_is_over && !interrupted();
  }

  // Both models at the last state: whole or not at all.
  bool models() {
    const auto is_of_variants = [&](const reports::PaperReport::Row& row) {
      return std::ranges::any_of(variants_,
                                 [&](const Variant& variant) { return variant.name() == row.quantity; });
    };
    std::ranges::remove_copy_if(earlier_rows_, std::back_inserter(report_.rows), is_of_variants);
    if (!report_.rows.empty()) return true;
    progress_.update("simulating", 0);
    profiler::PathCensus census;
    facts_.practical = {32, step_of(paper_variant(true), &census)};
    if (interrupted()) return false;
    facts_.simple = {32, step_of(paper_variant(false), nullptr)};
    if (interrupted()) return false;
    const auto here =
        timings_here(scene_, options_.device.backend_options(), options_.timed_steps, progress_);
    if (interrupted()) return false;
    report_.paths = paths_of(census, facts_.practical.forces().kernel);
    facts_.timings.insert(facts_.timings.begin(), here.begin(), here.end());
    reports::add_paper_rows(report_, facts_);
    return true;
  }

  bool variants() {
    std::vector<Machine> machines{facts_.paper_machine};
    if (facts_.machine->name != facts_.paper_machine.name) machines.push_back(*facts_.machine);
    const VariantRows predicted = variant_rows(scene_, variants_, machines, options_.device.backend_options(),
                                               MeasuredSteps(measured_steps_), earlier_rows_, progress_);
    report_.rows.insert(report_.rows.end(), predicted.rows.begin(), predicted.rows.end());
    n_variants_ = predicted.variants;
    return n_variants_ == variants_.size();
  }

  void write() {
    progress_.clear();
    if (!options_.checkpoint.empty()) write_particles(options_.checkpoint, scene_.particles);
    if (!options_.output.json.empty()) write_output(options_.output.json, reports::paper_json(report_));
    if (!options_.html.empty()) write_output(options_.html, reports::paper_page(report_));
    if (options_.output.summary() && options_.html != "-") std::cout << reports::text_paper(report_);
  }

  std::string how_far() const {
    return fmt::format("after {} steps, {} samples and {} of {} variants", report_.fall_steps,
                       report_.samples.size(), n_variants_, variants_.size());
  }

 private:
  void sample(std::uint64_t step) {
    if (!report_.samples.empty() && report_.samples.back().step == step) return;
    report_.samples.push_back(
        sample_state(scene_, step, paper_variant(true), how_, options_.device.backend_options()));
  }

  std::vector<profiler::LaunchCounters> step_of(const Variant& variant,
                                                profiler::WarpObserver* observer) const {
    profiler::ProfileOptions how = how_;
    how.observer = observer;
    std::vector<profiler::LaunchCounters> launches;
    for (profiler::LaunchProfile& launch :
         profile_step(scene_, variant, how, options_.device.backend_options()))
      launches.push_back(std::move(launch.counters));
    return launches;
  }

  const PaperOptions& options_;
  Progress progress_;
  reports::PaperFacts facts_;
  std::vector<Variant> variants_;
  std::vector<std::string> measured_steps_;  // documents
  Scene scene_;                              // particles as far as they have fallen
  profiler::ProfileOptions how_;
  reports::PaperReport report_;
  std::vector<reports::PaperReport::Row> earlier_rows_;
  std::size_t n_variants_ = 0;  // done
};

int paper(const PaperOptions& options) {
  if (options.samples == 0) throw_input_error("--samples", "0", "a number above 0");
  if (!options.checkpoint.empty()) make_folder(options.checkpoint);
  PaperStudy study(options);
  const InterruptWatch watch;
  if (options.resume) study.resume();
  const bool is_complete = study.fall() && study.models() && study.variants();
  study.write();
  return is_complete ? 0 : say_interrupted("paper", study.how_far(), options.checkpoint);
}

}  // namespace

void add_paper_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<PaperOptions>();
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
  CLI::Option* checkpoint = add_option(command, "--checkpoint", options->checkpoint);
  options->device.add_to(command);
  options->output.add_to(command);
  checkpoint->needs("--json");
  add_flag(command, "--resume", options->resume)->needs("--json")->needs(checkpoint);
  command.callback([options, &chosen] { chosen = [options] { return paper(*options); }; });
}

}  // namespace warpgrain::cli
