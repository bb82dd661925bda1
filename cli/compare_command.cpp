// `warpgrain compare`: two documents side by side, or a report beside what was measured.

#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/app.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "reports/comparison.hpp"
#include "reports/document_format.hpp"
#include "reports/html/comparison_page.hpp"
#include "reports/merged_sweeps.hpp"

namespace warpgrain::cli {
namespace {

struct CompareOptions {
  std::vector<std::string> documents, measured, metrics;
  std::optional<double> fail_above;
  OutputOptions output;
  std::string html;
};

// A sweep's folder or index; measurements of other programs need not even be JSON.
std::optional<std::filesystem::path> sweep_index(const std::filesystem::path& document) {
  if (std::filesystem::is_directory(document)) return document / reports::sweep_index_name;
  try {
    if (reports::format_of(document) == reports::sweep_format) return document;
  } catch (const InputError&) {
  }
  return std::nullopt;
}

reports::Comparison compared(const CompareOptions& options) {
  const std::string& first = options.documents.front();
  if (options.measured.empty()) {
    if (options.documents.size() != 2)
      throw_input_error("warpgrain compare", fmt::format("{} documents", options.documents.size()),
                        "two, or one with --measured");
    reports::Comparison comparison = reports::compare(
        reports::quantities_of(first), reports::quantities_of(options.documents[1]), options.metrics);
    comparison.base = first;
    comparison.other = options.documents[1];
    return comparison;
  }
  if (options.documents.size() != 1)
    throw_input_error("warpgrain compare", fmt::format("{} documents", options.documents.size()),
                      "one with --measured");
  if (const auto index = sweep_index(first)) {
    std::vector<reports::MeasuredReport> measured;
    for (const std::string& file : options.measured) measured.push_back(reports::read_measured(file));
    reports::Comparison comparison;
    comparison.order = reports::compare_order(reports::read_sweep(*index), measured);
    comparison.other = first;
    comparison.base = options.measured.front();
    return comparison;
  }
  if (options.measured.size() != 1)
    throw_input_error("--measured", fmt::format("{} files", options.measured.size()), "one beside a report");
  reports::Comparison comparison = reports::compare(reports::quantities_of(options.measured.front()),
                                                    reports::quantities_of(first), options.metrics);
  comparison.base = options.measured.front();
  comparison.other = first;
  return comparison;
}

int compare(const CompareOptions& options) {
  if (options.fail_above && !(*options.fail_above >= 0))
    throw_input_error("--fail-above", fmt::format("{}", *options.fail_above), "a percentage of 0 or more");
  reports::Comparison comparison = compared(options);
  if (!comparison.order && comparison.differences.empty())
    throw_input_error(comparison.other, fmt::format("nothing in common with {}", comparison.base),
                      "a kernel of the same name with a metric that both have");
  comparison.generator = reports::this_generator();
  comparison.command_line = command_line();
  if (!options.output.json.empty()) write_output(options.output.json, reports::comparison_json(comparison));
  if (!options.html.empty()) write_output(options.html, reports::comparison_page(comparison));
  if (options.output.summary() && options.html != "-") std::cout << reports::text_comparison(comparison);
  return options.fail_above && 100 * reports::largest_difference(comparison) > *options.fail_above ? 1 : 0;
}

}  // namespace

void add_compare_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App& command = *app.add_subcommand("compare", help_text().summary("compare"));
  add_option(command, "documents", options->documents)->required();
  add_option(command, "--measured", options->measured);
  add_option(command, "--metric", options->metrics);
  add_option(command, "--fail-above", options->fail_above);
  add_output_file(command, "--html", options->html);
  options->output.add_to(command);
  command.callback([options, &chosen] { chosen = [options] { return compare(*options); }; });
}

}  // namespace warpgrain::cli
