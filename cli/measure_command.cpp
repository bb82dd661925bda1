// `warpgrain measure`: times and counters of a launch or of a scene's step on a real device.

#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/app.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/interrupt.hpp"
#include "cli/measure_counters.hpp"
#include "cli/measure_launch.hpp"
#include "cli/measure_scene.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "reports/benchmark_json.hpp"
#include "reports/text_measured.hpp"

namespace warpgrain::cli {
namespace {

struct MeasureOptions {
  LaunchMeasurement launch;
  SceneOptions scene;
  VariantOptions variant;
  DeviceOptions device;
  SceneMeasurement step;
  double tolerance = 1e-5;
  bool counters = false, resume = false;
  std::string benchmark_json;
  OutputOptions output;
};

bool agrees(const reports::MeasuredReport& report, double tolerance) {
  for (const auto& kernel : report.kernels)
    for (const auto& agreement : kernel.agreement)
      if (!(agreement.largest_difference <= tolerance)) return false;
  return true;
}

// The call again that a profiler watches: what decides what runs, and nothing that decides what is written.
std::vector<std::string> marked_call(const MeasureOptions& options, const Scene* scene,
                                     const Variant* variant) {
  std::vector<std::string> words{"measure", "--mark", "--repeats", "1", "--warm-up", "0", "--quiet"};
  const auto add = [&words](const std::string& option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--device", options.device.device);
  if (scene == nullptr) {
    words.push_back(options.launch.launch);
    add("--build-options", options.launch.build_options);
    add("--assembler", options.launch.assembler);
    return words;
  }
  add("--scene", options.scene.scene);
  if (options.scene.particles) add("--particles", fmt::format("{}", *options.scene.particles));
  if (options.scene.seed) add("--seed", fmt::format("{}", *options.scene.seed));
  add("--variant", variant->name());
  add("--backend", options.step.backend);
  add("--kernels", options.device.kernels);
  add("--compiler", options.device.compiler);
  add("--steps", "1");
  add("--at-step", fmt::format("{}", options.step.at_step));
  return words;
}

reports::MeasuredReport measured_scene(MeasureOptions& options, const reports::MeasuredReport* earlier) {
  const Scene scene = options.scene.load();
  const Variant variant = options.variant.resolve(scene, options.device.kernels);
  if (options.counters && options.step.backend != "cuda")
    throw_input_error("--counters", fmt::format("--backend {}", options.step.backend),
                      "--backend cuda: Nsight Compute counts no other");
  options.step.options = options.device.backend_options(options.step.backend);
  options.step.warm_up = options.launch.warm_up;
  options.step.repeats = options.launch.repeats;
  options.step.mark = options.launch.mark;
  Progress progress(options.output.quiet);
  reports::MeasuredReport report = measure_scene(scene, variant, options.step, earlier, progress);
  if (options.counters && !interrupted()) count_with_ncu(marked_call(options, &scene, &variant), report);
  return report;
}

reports::MeasuredReport measured_launch(MeasureOptions& options, const reports::MeasuredReport* earlier) {
  options.launch.device = options.device.device;
  reports::MeasuredReport report = measure_launch(options.launch, earlier);
  if (options.counters && !interrupted()) count_with_ncu(marked_call(options, nullptr, nullptr), report);
  return report;
}

int measure(MeasureOptions options) {
  if (options.launch.repeats == 0) throw_input_error("--repeats", "0", "a number above 0");
  if (options.launch.in_a_row == 0) throw_input_error("--in-a-row", "0", "a number above 0");
  if (options.step.steps == 0) throw_input_error("--steps", "0", "a number above 0");
  if (options.launch.launch.empty() == options.scene.scene.empty())
    throw_input_error("warpgrain measure",
                      options.launch.launch.empty() ? "nothing to measure" : "both a launch file and --scene",
                      "either a launch file (.sim) or --scene FILE|NAME");
  std::optional<reports::MeasuredReport> earlier;
  if (options.resume) {
    earlier = reports::read_measured(options.output.json);
    require_same_call(options.output.json, earlier->command_line);
  }
  const InterruptWatch watch;
  const auto measured = options.launch.launch.empty() ? measured_scene : measured_launch;
  const reports::MeasuredReport report = measured(options, earlier ? &*earlier : nullptr);
  if (!options.output.json.empty()) write_output(options.output.json, reports::measured_json(report));
  if (!options.benchmark_json.empty()) write_output(options.benchmark_json, reports::benchmark_json(report));
  if (options.output.summary()) std::cout << reports::text_measured(report);
  if (interrupted())
    return say_interrupted("measure", fmt::format("before the last of {} readings", options.launch.repeats),
                           options.output.json);
  return agrees(report, options.tolerance) ? 0 : 1;
}

}  // namespace

void add_measure_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<MeasureOptions>();
  options->step.backend = "opencl";
  CLI::App& command = *app.add_subcommand("measure", help_text().summary("measure"));
  add_option(command, "launch", options->launch.launch);
  add_option(command, "--build-options", options->launch.build_options);
  add_option(command, "--assembler", options->launch.assembler);
  add_option(command, "--keep", options->launch.keep);
  add_flag(command, "--check", options->launch.check);
  add_option(command, "--tolerance", options->tolerance);
  options->scene.add_to(command);
  add_option(command, "--backend", options->step.backend);
  add_option(command, "--at-step", options->step.at_step);
  add_option(command, "--steps", options->step.steps);
  add_option(command, "--repeats", options->launch.repeats);
  add_option(command, "--warm-up", options->launch.warm_up);
  add_option(command, "--in-a-row", options->launch.in_a_row);
  add_flag(command, "--counters", options->counters);
  add_flag(command, "--mark", options->launch.mark);
  add_option(command, "--benchmark-json", options->benchmark_json);
  options->variant.add_to(command);
  options->device.add_to(command);
  options->device.add_keeping_to(command);
  options->output.add_to(command);
  add_flag(command, "--resume", options->resume)->needs("--json");
  command.callback([options, &chosen] { chosen = [options] { return measure(*options); }; });
}

}  // namespace warpgrain::cli
