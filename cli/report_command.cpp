// `warpgrain report`: a document that is there already, for people.

#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "cli/app.hpp"
#include "cli/common_options.hpp"
#include "cli/help_text.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "reports/document_format.hpp"
#include "reports/html/accuracy_page.hpp"
#include "reports/html/comparison_page.hpp"
#include "reports/html/paper_page.hpp"
#include "reports/html/report_page.hpp"
#include "reports/html/sweep_page.hpp"
#include "reports/merged_sweeps.hpp"
#include "reports/report_json.hpp"
#include "reports/run_report.hpp"
#include "reports/stability_report.hpp"
#include "reports/table_files.hpp"
#include "reports/text_report.hpp"
#include "reports/text_run.hpp"
#include "reports/text_sweep.hpp"

namespace warpgrain::cli {
namespace {

struct Options {
  std::string document;
  std::string html, csv, baseline;
  bool markdown = false;
  bool quiet = false;
};

void refuse(const std::string& option, const std::string& format, const char* expected) {
  throw_input_error(option, fmt::format("a document of {}", format), expected);
}

int render_sweep(const Options& options, const std::filesystem::path& file) {
  const reports::SweepIndex index = reports::read_sweep(file);
  std::optional<reports::SweepIndex> baseline;
  if (!options.baseline.empty()) {
    std::filesystem::path earlier = options.baseline;
    if (std::filesystem::is_directory(earlier)) earlier /= reports::sweep_index_name;
    baseline = reports::read_sweep(earlier);
  }
  if (!options.html.empty())
    write_output(options.html, reports::sweep_page(index, baseline ? &*baseline : nullptr));
  if (!options.csv.empty()) write_output(options.csv, reports::csv_sweep(index));
  if (options.markdown)
    std::cout << reports::markdown_sweep(index);
  else if (!options.quiet && options.html != "-" && options.csv != "-")
    std::cout << reports::text_sweep(index);
  return 0;
}

int render(const Options& options) {
  std::filesystem::path file = options.document;
  if (std::filesystem::is_directory(file)) file /= reports::sweep_index_name;
  const std::string format = reports::format_of(file);
  if (format == reports::sweep_format) return render_sweep(options, file);
  if (options.markdown) refuse("--markdown", format, "a sweep");
  if (!options.csv.empty()) refuse("--csv", format, "a sweep");
  if (!options.baseline.empty()) refuse("--baseline", format, "a sweep");
  const bool show = !options.quiet && options.html != "-";
  if (format == reports::report_format) {
    const reports::Report report = reports::read_report(file);
    if (!options.html.empty()) write_output(options.html, reports::report_page(report));
    if (show) std::cout << reports::text_report(report);
  } else if (format == reports::run_format) {
    if (!options.html.empty()) refuse("--html", format, "any but a run");
    if (show) std::cout << reports::text_run(reports::read_run(file));
  } else if (format == reports::paper_format) {
    const reports::PaperReport report = reports::read_paper(file);
    if (!options.html.empty()) write_output(options.html, reports::paper_page(report));
    if (show) std::cout << reports::text_paper(report);
  } else if (format == reports::comparison_format) {
    const reports::Comparison comparison = reports::read_comparison(file);
    if (!options.html.empty()) write_output(options.html, reports::comparison_page(comparison));
    if (show) std::cout << reports::text_comparison(comparison);
  } else if (format == reports::accuracy_format) {
    const reports::AccuracyReport report = reports::read_accuracy(file);
    if (!options.html.empty()) write_output(options.html, reports::accuracy_page(report));
    if (show) std::cout << reports::text_accuracy(report);
  } else if (format == reports::stability_format) {
    const reports::StabilityReport report = reports::read_stability(file);
    if (!options.html.empty()) write_output(options.html, reports::stability_page(report));
    if (show) std::cout << reports::text_stability(report);
  } else {
    const std::array known{reports::report_format,   reports::run_format,        reports::sweep_format,
                           reports::paper_format,    reports::comparison_format, reports::accuracy_format,
                           reports::stability_format};
    throw_unknown_name(file.string(), "format", format, known);
  }
  return 0;
}

}  // namespace

void add_report_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<Options>();
  CLI::App& command = *app.add_subcommand("report", help_text().summary("report"));
  add_option(command, "document", options->document)->required();
  add_option(command, "--html", options->html);
  add_option(command, "--baseline", options->baseline);
  add_option(command, "--csv", options->csv);
  add_flag(command, "--markdown", options->markdown);
  add_flag(command, "--quiet", options->quiet);
  command.callback([options, &chosen] { chosen = [options] { return render(*options); }; });
}

}  // namespace warpgrain::cli
