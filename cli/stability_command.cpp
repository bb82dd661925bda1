// `warpgrain stability`: where each variant stops being right, by bisection.

#include <algorithm>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "cli/app.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/stability_atlas.hpp"
#include "cli/sweep_plan.hpp"
#include "core/error.hpp"
#include "variants/contact_laws.hpp"

namespace warpgrain::cli {
namespace {

struct StabilityOptions {
  std::vector<std::string> axis, backends, probes;
  std::uint64_t rest_steps = 1000;
  int samples = 5, halvings = 6;
  DeviceOptions device;
  OutputOptions output;
  std::string html;
  bool markdown = false, resume = false;
};

std::vector<const Probe*> chosen_probes(const StabilityOptions& options) {
  std::vector<const Probe*> chosen;
  for (const std::string& name : options.probes) chosen.push_back(&probe_named(name));
  if (chosen.empty())
    for (const Probe& probe : probes()) chosen.push_back(&probe);
  return chosen;
}

// Of a variant the host knows the model and the precision: one case each.
bool is_known_to_host(const Variant& variant, std::set<std::string>& known) {
  return !known
              .insert(fmt::format("{} {}", static_cast<int>(contact_law(variant).model),
                                  variant.value(AxisId::precision)))
              .second;
}

std::vector<ProbeBench> chosen_benches(const StabilityOptions& options) {
  const std::vector<Variant> variants =
      options.axis.empty() ? variants_that_compute_differently() : swept_variants(options.axis);
  std::vector<ProbeBench> benches;
  for (const std::string& name : options.backends) {
    const Backend& chosen = backend(name);
    if (const std::string lacks = chosen.lacks(); !lacks.empty())
      throw_input_error("--backend", fmt::format("{}: {}", name, lacks));
    std::set<std::string> known;
    for (const Variant& variant : variants)
      if (chosen.name != "host" || !is_known_to_host(variant, known))
        benches.emplace_back(chosen, variant, options.device.backend_options(), options.rest_steps);
  }
  return benches;
}

int stability(const StabilityOptions& options) {
  if (options.rest_steps < 20)
    throw_input_error("--rest-steps", fmt::format("{}", options.rest_steps), "at least 20");
  if (options.samples < 2 || options.samples > 1000)
    throw_input_error("--samples", fmt::format("{}", options.samples), "2 to 1000");
  if (options.halvings < 0 || options.halvings > 50)
    throw_input_error("--halvings", fmt::format("{}", options.halvings), "0 to 50");
  const std::vector<const Probe*> asked = chosen_probes(options);
  const std::vector<ProbeBench> benches = chosen_benches(options);

  reports::StabilityReport report;
  report.generator = reports::this_generator();
  report.command_line = command_line();
  for (const Probe* probe : asked) report.probes.push_back(described(*probe, options.rest_steps));
  std::vector<reports::StabilityReport::Cell> earlier;
  if (options.resume) {
    reports::StabilityReport partial = reports::read_stability(options.output.json);
    require_same_call(options.output.json, partial.command_line);
    earlier = std::move(partial.cells);
  }
  Progress progress(options.output.quiet);
  const std::size_t n_cells = benches.size() * asked.size();
  const InterruptWatch watch;
  for (const ProbeBench& bench : benches)
    for (const Probe* probe : asked) {
      const auto known = std::ranges::find_if(earlier, [&](const reports::StabilityReport::Cell& cell) {
        return cell.probe == probe->name && cell.variant == bench.variant().name() &&
               cell.backend == bench.backend().name;
      });
      if (known != earlier.end()) {
        report.cells.push_back(*known);
        continue;
      }
      if (interrupted()) break;
      progress.update("probing", static_cast<double>(report.cells.size()) / static_cast<double>(n_cells),
                      fmt::format("{} {}", probe->name, bench.variant().name()));
      report.cells.push_back(find_cell(*probe, bench, {options.samples, options.halvings}));
    }
  progress.clear();
  if (!options.html.empty()) write_output(options.html, reports::stability_page(report));
  if (!options.output.json.empty()) write_output(options.output.json, reports::stability_json(report));
  if (options.output.summary() && options.html != "-")
    std::cout << (options.markdown ? reports::markdown_stability(report) : reports::text_stability(report));
  if (report.cells.size() < n_cells)
    return say_interrupted("stability", fmt::format("after {} of its cases", report.cells.size()),
                           options.output.json);
  return 0;
}

}  // namespace

void add_stability_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<StabilityOptions>();
  options->backends = {"opencl"};
  CLI::App& command = *app.add_subcommand("stability", help_text().summary("stability"));
  add_option(command, "--axis", options->axis);
  add_option(command, "--backend", options->backends)->delimiter(',');
  add_option(command, "--probe", options->probes)->delimiter(',');
  add_option(command, "--rest-steps", options->rest_steps);
  add_option(command, "--samples", options->samples);
  add_option(command, "--halvings", options->halvings);
  add_output_file(command, "--html", options->html);
  add_flag(command, "--markdown", options->markdown);
  options->device.add_to(command);
  options->output.add_to(command);
  add_flag(command, "--resume", options->resume)->needs("--json");
  command.callback([options, &chosen] { chosen = [options] { return stability(*options); }; });
}

}  // namespace warpgrain::cli
