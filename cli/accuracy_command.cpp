// `warpgrain accuracy`: what each variant costs, and how far it is off at every level that matters.

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/confidence.hpp"
#include "analysis/float_spacing.hpp"
#include "analysis/force_error.hpp"
#include "cli/accuracy/collision_level.hpp"
#include "cli/accuracy/convergence_study.hpp"
#include "cli/accuracy/cost_level.hpp"
#include "cli/accuracy/divergence_level.hpp"
#include "cli/accuracy/ensemble_level.hpp"
#include "cli/accuracy/impact_study.hpp"
#include "cli/accuracy/options.hpp"
#include "cli/accuracy/setting.hpp"
#include "cli/app.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/run_loop.hpp"
#include "cli/sweep_plan.hpp"
#include "core/error.hpp"
#include "core/reference_forces.hpp"
#include "reports/accuracy_report.hpp"
#include "reports/html/accuracy_page.hpp"
#include "reports/study_report.hpp"

namespace warpgrain::cli {
namespace {

constexpr std::uint64_t default_particles = 300;

std::vector<AccuracyCase> cases_of(const AccuracyOptions& options, const std::vector<Variant>& by_default) {
  const std::vector<Variant> variants = options.axis.empty() ? by_default : swept_variants(options.axis);
  std::vector<AccuracyCase> cases;
  for (const double factor : options.step_factors)
    for (const Variant& variant : variants) cases.push_back({variant, factor, options.simulate});
  return cases;
}

// Goes through the cases of one study.
class AccuracyStudy {
 public:
  explicit AccuracyStudy(const AccuracyOptions& options)
      : options_(options), progress_(options.output.quiet), measured_(options.measured) {
    if (!options.machine.empty()) setting_.machine = load_machine(options.machine);
    if (options.cost == "predicted_seconds" && !setting_.machine->cost)
      throw_input_error("--machine", fmt::format("{} has no cost constants", options.machine),
                        "a machine that has, as hopper_h100");
    cases_ = cases_of(options, variants_that_compute_differently());
    SceneOptions chosen = options.scene;
    if (chosen.scene.empty()) {
      chosen.scene = "settled_bed";
      if (!chosen.particles) chosen.particles = default_particles;
    }
    setting_.scene = chosen.load();
    larger_ = chosen;
    larger_.particles = options.cost_particles;
    setting_.backend = options.device.backend_options();
    setting_.divergence_steps = options.trajectory_steps;
    setting_.timed_steps = options.timed_steps;
  }

  // Keeps the cases of an earlier call.
  void resume(const std::string& file) {
    reports::AccuracyReport earlier = reports::read_accuracy(file);
    require_same_call(file, earlier.command_line);
    earlier_ = std::move(earlier.cases);
  }

  // Whether Ctrl-C has left some undone.
  bool is_complete() const { return done_ == cases_.size(); }

  reports::AccuracyReport run() {
    setting_.at_step = advanced(setting_.scene, Variant{}, setting_.backend, options_.at_step, progress_);
    setting_.costed = options_.cost_particles
                          ? advanced(larger_.load(), Variant{}, setting_.backend, options_.at_step, progress_)
                          : setting_.at_step;
    prepare_references();
    reports::AccuracyReport report;
    report.generator = reports::this_generator();
    report.command_line = command_line();
    report.scene = setting_.scene.name;
    report.particles = setting_.scene.particles.size();
    report.seed = setting_.scene.seed;
    report.step = options_.at_step;
    report.time_step = setting_.scene.time_step;
    report.seeds = options_.has("ensemble") ? options_.seeds : 0;
    report.cost = options_.cost;
    report.cost_particles = setting_.costed.particles.size();
    if (setting_.machine) report.machine = setting_.machine->name;
    report.measured = measured_.of_what();
    for (const AccuracyCase& which : cases_) {
      const auto known = std::ranges::find_if(earlier_, [&](const auto& row) {
        return row.variant == which.variant.name() && row.step_factor == which.step_factor;
      });
      if (known == earlier_.end() && interrupted()) break;
      report.cases.push_back(known == earlier_.end() ? study(which) : *known);
      ++done_;
    }
    progress_.clear();
    reports::rank_cases(report);
    return report;
  }

 private:
  void prepare_references() {
    progress_.update("reference", 0);
    const Scene& scene = setting_.at_step;
    if (options_.has("force")) forces_ = evaluate_forces(scene, scene.particles, scene.time_step).forces;
    if (options_.has("trajectory")) trajectory_ = reference_trajectory(setting_);
    Variant reference;
    reference.set("precision", "fp64");
    if (scene.model.contact == ContactModel::simple) reference.set("contact", "simple");
    if (options_.has("ensemble"))
      ensemble_ = ensemble(options_.seeds, backend("host"), reference, setting_.backend, 1);
    if (!options_.has("collision")) return;
    constexpr double fine = 0.01;  // of the scene's step
    collisions_ = collisions(scene, backend("host"), reference, setting_.backend, fine * scene.time_step);
  }

  reports::AccuracyReport::Case study(const AccuracyCase& which) {
    reports::AccuracyReport::Case row;
    row.variant = which.variant.name();
    row.step_factor = which.step_factor;
    row.backend = which.runs_on().name;
    const auto say = [&](std::string_view what) {
      progress_.update("studying", static_cast<double>(done_) / static_cast<double>(cases_.size()),
                       fmt::format("{}: {}", which.name(), what));
    };
    try {
      say("cost");
      const StepCost cost = cost_of(setting_, which.variant);
      row.warp_instructions = cost.warp_instructions;
      row.bytes = cost.bytes;
      row.seconds = cost.seconds;
      row.predicted_seconds = cost.predicted_seconds;
      row.measured_seconds = measured_.seconds(which.variant);
      say("forces");
      if (options_.has("force")) row.force = force_level(which);
      say("collisions");
      if (options_.has("collision")) row.collision = collision_level(which);
      say("trajectories");
      if (options_.has("trajectory")) row.trajectory = trajectory_level(which);
      say("ensemble");
      if (options_.has("ensemble")) row.ensemble = ensemble_level(which);
    } catch (const InputError& error) {
      row.failure = error.what();
    }
    return row;
  }

  reports::AccuracyReport::Force force_level(const AccuracyCase& which) const {
    const auto simulation = which.runs_on().create(setting_.at_step, which.variant, setting_.backend);
    const VectorError error = force_error(setting_.at_step.particles, simulation->forces(), forces_).force;
    return {error.maximum, error.root_mean_square, in_float_ulps(error.maximum * error.scale, error.scale),
            in_float_ulps(error.root_mean_square * error.scale, error.scale)};
  }

  reports::AccuracyReport::Collision collision_level(const AccuracyCase& which) const {
    const auto seen = collisions(setting_.at_step, which.runs_on(), which.variant, setting_.backend,
                                 which.step_factor * setting_.at_step.time_step);
    const CollisionError error = collision_error(seen, collisions_);
    return {error.restitution, error.rebound_angle, error.spin};
  }

  reports::AccuracyReport::Trajectory trajectory_level(const AccuracyCase& which) const {
    const Divergence parted = divergence(setting_, which, trajectory_);
    return {parted.time, parted.compared, parted.root_mean_square};
  }

  // The simulator, some hundred times slower, has no approximation that would show in a mean.
  std::vector<reports::AccuracyReport::Ensemble> ensemble_level(const AccuracyCase& which) const {
    const auto seen =
        ensemble(options_.seeds, backend("opencl"), which.variant, setting_.backend, which.step_factor);
    std::vector<reports::AccuracyReport::Ensemble> rows;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const MeanInterval mean = mean_interval(seen[k].values);
      const MeanInterval difference =
          difference_of_means(seen[k].values, ensemble_[k].values, seen.size() * cases_.size());
      rows.push_back({seen[k].name, seen[k].unit, mean.mean, mean.half_width, difference.mean,
                      difference.half_width, is_significant(difference)});
    }
    return rows;
  }

  const AccuracyOptions& options_;
  Progress progress_;
  MeasuredSteps measured_;
  AccuracySetting setting_;
  SceneOptions larger_;  // of which costs are counted, where that is another
  std::vector<AccuracyCase> cases_;
  std::vector<reports::AccuracyReport::Case> earlier_;
  std::size_t done_ = 0;
  ForceState forces_;
  Trajectory trajectory_;
  std::vector<CollisionOutcome> collisions_;
  std::vector<EnsembleQuantity> ensemble_;
};

int tables_of_study(const AccuracyOptions& options) {
  reports::StudyReport report;
  report.generator = reports::this_generator();
  report.command_line = command_line();
  report.study = options.study;
  report.tables = options.study == "impacts"
                      ? impact_tables(cases_of(options, {Variant()}), options.device.backend_options())
                      : convergence_tables();
  if (!options.output.json.empty()) write_output(options.output.json, reports::study_json(report));
  if (options.output.summary())
    std::cout << (options.markdown ? reports::markdown_study(report) : reports::text_study(report));
  return 0;
}

int accuracy(const AccuracyOptions& options) {
  require_sensible_options(options);
  if (options.study != variants_study) return tables_of_study(options);
  const InterruptWatch watch;
  AccuracyStudy study(options);
  if (options.resume) study.resume(options.output.json);
  const reports::AccuracyReport report = study.run();
  if (!options.output.json.empty()) write_output(options.output.json, reports::accuracy_json(report));
  if (!options.html.empty()) write_output(options.html, reports::accuracy_page(report));
  if (options.output.summary() && options.html != "-") std::cout << reports::text_accuracy(report);
  if (study.is_complete()) return 0;
  return say_interrupted("accuracy", fmt::format("after {} of its cases", report.cases.size()),
                         options.output.json);
}

}  // namespace

void add_accuracy_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<AccuracyOptions>();
  CLI::App& command = *app.add_subcommand("accuracy", help_text().summary("accuracy"));
  options->scene.add_to(command);
  add_option(command, "--study", options->study);
  add_flag(command, "--markdown", options->markdown);
  add_option(command, "--axis", options->axis);
  add_flag(command, "--simulate", options->simulate);
  add_option(command, "--cost", options->cost);
  add_option(command, "--cost-particles", options->cost_particles);
  add_option(command, "--machine", options->machine);
  add_option(command, "--measured", options->measured)->delimiter(',');
  add_option(command, "--level", options->levels)->delimiter(',');
  add_option(command, "--step-factor", options->step_factors)->delimiter(',');
  add_option(command, "--at-step", options->at_step);
  add_option(command, "--steps", options->timed_steps);
  add_option(command, "--trajectory-steps", options->trajectory_steps);
  add_option(command, "--seeds", options->seeds);
  add_output_file(command, "--html", options->html);
  options->device.add_to(command);
  options->output.add_to(command);
  add_flag(command, "--resume", options->resume)->needs("--json");
  command.callback([options, &chosen] { chosen = [options] { return accuracy(*options); }; });
}

}  // namespace warpgrain::cli
