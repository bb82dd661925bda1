// `warpgrain measure`: times of a launch on a CUDA device.

#include <iostream>
#include <memory>

#include "cli/app.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/measure_launch.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "reports/text_measured.hpp"

namespace warpgrain::cli {
namespace {

struct Options {
  LaunchMeasurement launch;
  double tolerance = 1e-5;
  OutputOptions output;
};

bool agrees(const reports::MeasuredReport& report, double tolerance) {
  for (const auto& kernel : report.kernels)
    for (const auto& agreement : kernel.agreement)
      if (!(agreement.largest_difference <= tolerance)) return false;
  return true;
}

int measure(const Options& options) {
  if (options.launch.repeats == 0) throw_input_error("--repeats", "0", "a number above 0");
  const reports::MeasuredReport report = measure_launch(options.launch);
  if (!options.output.json.empty()) write_output(options.output.json, reports::measured_json(report));
  if (options.output.summary()) std::cout << reports::text_measured(report);
  return agrees(report, options.tolerance) ? 0 : 1;
}

}  // namespace

void add_measure_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand("measure", help_text().summary("measure"));
  add_option(command, "launch", options->launch.launch)->required();
  add_option(command, "--build-options", options->launch.build_options);
  add_option(command, "--device", options->launch.device);
  add_option(command, "--repeats", options->launch.repeats);
  add_option(command, "--warm-up", options->launch.warm_up);
  add_option(command, "--assembler", options->launch.assembler);
  add_option(command, "--keep", options->launch.keep);
  add_flag(command, "--check", options->launch.check);
  add_option(command, "--tolerance", options->tolerance);
  options->output.add_to(command);
  command.callback([options, &chosen] { chosen = [options] { return measure(*options); }; });
}

}  // namespace warpgrain::cli
