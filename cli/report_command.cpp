// `warpgrain report`: a document that is there already, for people.

#include <algorithm>
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

struct ReportOptions {
  std::string document;
  std::string html, csv, baseline;
  bool markdown = false;
  bool quiet = false;
};

[[noreturn]] void refuse(const std::string& option, const std::string& format, const char* expected) {
  throw_input_error(option, fmt::format("a document of {}", format), expected);
}

void render_sweep(const ReportOptions& options, const std::filesystem::path& file) {
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
}

std::string plain_text_report(const reports::Report& report) { return reports::text_report(report); }
std::string no_page(const reports::RunReport&) {
  refuse("--html", std::string(reports::run_format), "any but a run");
}

// A document of one thing, read, and shown as a page and as text.
template <auto read, auto page, auto text>
void render_document(const ReportOptions& options, const std::filesystem::path& file) {
  const auto document = read(file);
  if (!options.html.empty()) write_output(options.html, page(document));
  if (!options.quiet && options.html != "-") std::cout << text(document);
}

struct Renderer {
  std::string_view format;
  void (*render)(const ReportOptions&, const std::filesystem::path&);
};
constexpr std::array renderers{
    Renderer{reports::report_format,
             render_document<reports::read_report, reports::report_page, plain_text_report>},
    Renderer{reports::run_format, render_document<reports::read_run, no_page, reports::text_run>},
    Renderer{reports::sweep_format, render_sweep},
    Renderer{reports::paper_format,
             render_document<reports::read_paper, reports::paper_page, reports::text_paper>},
    Renderer{reports::comparison_format,
             render_document<reports::read_comparison, reports::comparison_page, reports::text_comparison>},
    Renderer{reports::accuracy_format,
             render_document<reports::read_accuracy, reports::accuracy_page, reports::text_accuracy>},
    Renderer{reports::stability_format,
             render_document<reports::read_stability, reports::stability_page, reports::text_stability>}};

int render(const ReportOptions& options) {
  std::filesystem::path file = options.document;
  if (std::filesystem::is_directory(file)) file /= reports::sweep_index_name;
  const std::string format = reports::format_of(file);
  const auto known = std::ranges::find(renderers, format, &Renderer::format);
  if (known == renderers.end()) {
    std::array<std::string_view, renderers.size()> names;
    std::ranges::transform(renderers, names.begin(), &Renderer::format);
    throw_unknown_name(file.string(), "format", format, names);
  }
  if (format != reports::sweep_format) {
    if (options.markdown) refuse("--markdown", format, "a sweep");
    if (!options.csv.empty()) refuse("--csv", format, "a sweep");
    if (!options.baseline.empty()) refuse("--baseline", format, "a sweep");
  }
  known->render(options, file);
  return 0;
}

}  // namespace

void add_report_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App& command = *app.add_subcommand("report", help_text().summary("report"));
  add_option(command, "document", options->document)->required();
  add_output_file(command, "--html", options->html);
  add_option(command, "--baseline", options->baseline);
  add_output_file(command, "--csv", options->csv);
  add_flag(command, "--markdown", options->markdown);
  add_flag(command, "--quiet", options->quiet);
  command.callback([options, &chosen] { chosen = [options] { return render(*options); }; });
}

}  // namespace warpgrain::cli
