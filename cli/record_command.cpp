// `warpgrain record`: the divergence report of the launches of an OpenCL program that knows nothing of it.

#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/machine.hpp"
#include "cli/app.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/profile_options.hpp"
#include "cli/record_settings.hpp"
#include "cli/recorded_launches.hpp"
#include "cli/recorded_program.hpp"
#include "core/error.hpp"
#include "profiler/subprocess.hpp"
#include "reports/html/report_page.hpp"
#include "reports/ptx_files.hpp"
#include "reports/report_json.hpp"
#include "reports/text_report.hpp"

namespace warpgrain::cli {
namespace {

struct RecordOptions {
  std::vector<std::string> program;
  RecordSettings settings;
  std::uint64_t memory = 4096;  // MiB
  std::string save;
  DeviceOptions device;
  SimulatorOptions simulator;
  OutputOptions output;
  std::string html;
};

void check(const RecordOptions& options) {
  const RecordSettings& settings = options.settings;
  for (const auto& [option, value] : {std::pair{"--first", settings.first}, {"--every", settings.every}})
    if (value == 0) throw_input_error(option, "0", "a number above 0");
  if (options.memory > std::uint64_t{1} << 40)
    throw_input_error("--memory", fmt::format("{} MiB", options.memory), "at most 2^40 MiB");
  if (!options.save.empty() && std::filesystem::exists(std::filesystem::path(options.save) / record_index))
    throw_input_error("--save", fmt::format("'{}' holds recorded launches", options.save), "another folder");
  // What a program that is ended leaves half-written is removed: it must not be the user's.
  if (std::filesystem::is_directory(options.save) && !std::filesystem::is_empty(options.save))
    throw_input_error("--save", fmt::format("'{}' holds files", options.save), "an empty or a new folder");
}

reports::Report report_of(const RecordedProfiles& profiles, const std::optional<Machine>& machine,
                          const RecordOptions& options) {
  reports::Report report = reports::make_report(profiles.launches, command_line());
  const std::string& json = options.output.json;
  if (!json.empty() && json != "-") reports::keep_ptx(report, profiles.launches, json);
  report.machine = machine;
  report.limits.insert(report.limits.end(), profiles.remarks.begin(), profiles.remarks.end());
  return report;
}

// The summary goes to stderr: stdout is the program's. There are no documents of nothing.
void write(const reports::Report& report, const RecordedProfiles& profiles, const RecordOptions& options) {
  const bool has_launches = !report.launches.empty();
  if (has_launches && !options.output.json.empty())
    write_output(options.output.json, reports::report_json(report));
  if (has_launches && !options.html.empty()) write_output(options.html, reports::report_page(report));
  if (has_launches && !options.output.quiet) std::cerr << '\n' << reports::text_report(report);
  for (const std::string& line : profiles.remarks) std::cerr << "warpgrain record: " << line << '\n';
  if (!has_launches)
    std::cerr << "warpgrain record: no launch of a kernel was profiled; no report is written\n";
}

int record(RecordOptions options) {
  check(options);
  Progress progress(options.output.quiet);
  const profiler::ProfileOptions how = options.simulator.profile_options(options.device, progress);
  const auto machine = options.simulator.load_machine();  // before the program runs, as all that can be wrong
  const std::filesystem::path layer = find_layer();
  options.settings.memory = options.memory << 20;
  std::optional<profiler::TemporaryFolder> temporary;
  if (options.save.empty())
    options.settings.folder = temporary.emplace().path();
  else
    make_folder(options.save);
  if (!temporary) options.settings.folder = std::filesystem::absolute(options.save);
  const InterruptWatch watch({SIGINT});  // which the program alone takes while it runs
  const int status = run_recorded(options.program, layer, options.settings);
  if (!std::filesystem::exists(options.settings.folder / record_index)) {
    std::cerr << "warpgrain record: no call of OpenCL was seen: the program makes none, or its loader takes "
                 "no layers\n";
    return status;
  }
  remove_unfinished(options.settings.folder);
  const RecordedProfiles profiles = profile_recorded(options.settings.folder, how, progress);
  progress.clear();
  write(report_of(profiles, machine, options), profiles, options);
  return profiles.interrupted ? interrupted_status : status;
}

}  // namespace

void add_record_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<RecordOptions>();
  CLI::App& command = *app.add_subcommand("record", help_text().summary("record"));
  add_option(command, "program", options->program)->required();
  add_option(command, "--kernel", options->settings.kernels);
  add_option(command, "--first", options->settings.first);
  add_option(command, "--every", options->settings.every);
  add_option(command, "--largest", options->settings.largest);
  add_option(command, "--memory", options->memory);
  add_option(command, "--save", options->save);
  add_output_file(command, "--html", options->html);
  options->simulator.timeline_warps = {"none"};  // of many launches they would be most of the report
  options->simulator.add_to(command);
  add_option(command, "--threads", options->device.threads);
  options->output.add_to(command);
  command.callback([options, &chosen] { chosen = [options] { return record(*options); }; });
}

}  // namespace warpgrain::cli
