#include "reports/html/paper_page.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "reports/html/charts.hpp"
#include "reports/html/page.hpp"
#include "reports/html/provenance.hpp"
#include "reports/html/samples_view.hpp"
#include "reports/html/table.hpp"
#include "reports/number_text.hpp"

namespace warpgrain::reports {
namespace {

using Row = PaperReport::Row;

html::Cell paper_cell(const std::optional<double>& value) {
  if (!value) return html::text_cell("-");
  return {std::abs(*value) >= 1e5 ? count_text(static_cast<std::uint64_t>(std::llround(*value)))
                                  : fmt::format("{:.4g}", *value),
          *value,
          {}};
}

std::string name_with_unit(const Row& row) {
  return row.unit.empty() ? row.quantity : fmt::format("{} [{}]", row.quantity, row.unit);
}

// The first measured value, and the others below it.
html::Cell measured_cell(const Row& row) {
  if (row.measured.empty()) return html::text_cell("-");
  html::Cell cell = paper_cell(row.measured[0].value);
  cell.html.clear();
  for (const PaperReport::Measured& measured : row.measured)
    cell.html += fmt::format("<span class=\"wrap\">{} <span class=\"soft\">{}</span></span>{}",
                             paper_cell(measured.value).html, html::escape(measured.on),
                             &measured == &row.measured.back() ? "" : "<br/>");
  return cell;
}

html::Table section_table(const std::vector<const Row*>& rows) {
  html::Table table({{"quantity", "in brackets its unit; without one a ratio or a count", true},
                     {"paper", "as the paper has it"},
                     {"model", "the paper's formula, computed"},
                     {"simulated", "counted by the simulator"},
                     {"measured", "on a real device", true},
                     {"remark", "what the values are, where that is not plain", true}});
  for (const Row* row : rows)
    table.add_row({html::text_cell(name_with_unit(*row)), paper_cell(row->paper), paper_cell(row->model),
                   paper_cell(row->simulated), measured_cell(*row), html::wrapped_cell(row->remark)});
  return table;
}

// The values of a section that have a unit or are factors, beside each other; where one source alone has
// values there is nothing to compare.
std::string section_chart(const std::string& section, const std::vector<const Row*>& rows) {
  std::string unit;
  for (const Row* row : rows)
    if (!row->unit.empty()) unit = row->unit;
  html::BarChart chart;
  chart.log = true;
  chart.value = unit.empty() ? "ratio or count" : unit;
  chart.series = {{"paper", {}}, {"model", {}}, {"simulated", {}}, {"measured", {}}};
  for (const Row* row : rows) {
    if (row->unit != unit) continue;
    const std::optional<double> measured =
        row->measured.empty() ? std::nullopt : std::optional(row->measured[0].value);
    const std::optional<double> values[] = {row->paper, row->model, row->simulated, measured};
    if (std::ranges::count_if(values, [](const auto& value) { return value && *value > 0; }) < 2) continue;
    chart.names.push_back(row->quantity);
    for (std::size_t k = 0; k < 4; ++k)
      chart.series[k].values.push_back(values[k] && *values[k] > 0 ? values[k] : std::nullopt);
  }
  return html::bar_chart(section + ", side by side", chart);
}

std::string sections_html(const PaperReport& report) {
  std::vector<std::pair<std::string, std::vector<const Row*>>> sections;
  for (const Row& row : report.rows) {
    if (sections.empty() || sections.back().first != row.section) sections.push_back({row.section, {}});
    sections.back().second.push_back(&row);
  }
  std::string html;
  for (const auto& [section, rows] : sections)
    html += fmt::format("<h2>{}</h2>\n{}{}", html::escape(section), section_table(rows).html(),
                        section_chart(section, rows));
  return html;
}

std::string paths_html(const PaperReport& report) {
  if (report.paths.empty()) return {};
  html::Table table({{"body at", "a loop, or the kernel outside of loops", true},
                     {"branches", "conditional ones of the body"},
                     {"paths allowed", "2 to the number of branches"},
                     {"paths taken", "different ones that lanes took"},
                     {"passes of lanes", "how often lanes went through the body"},
                     {"share of instructions", "of all that lanes ran"}});
  for (const PaperReport::Paths& paths : report.paths)
    table.add_row(
        {html::text_cell(paths.line == 0 ? paths.kernel : fmt::format("{}:{}", paths.file, paths.line)),
         html::count_cell(paths.branches), paper_cell(std::exp2(paths.branches)),
         html::count_cell(paths.paths), html::count_cell(paths.passes),
         html::share_cell(paths.instruction_share, 1)});
  return fmt::format("<h2>Paths of lanes through <code>{}</code></h2>\n{}",
                     html::escape(report.paths.front().kernel), table.html());
}

}  // namespace

std::string paper_page(const PaperReport& report) {
  const std::string title = "Washizawa and Nakahara's tables and figures";
  std::string body = fmt::format(
      "<h1>{}</h1>\n<p class=\"soft\">{}, {} particles. Point at a heading for what a column holds.</p>\n",
      title, html::escape(report.scene), count_text(report.particles));
  body += sections_html(report) + html::samples_view(report.samples) + paths_html(report);
  body += html::provenance(report.generator, report.command_line,
                           {{"format", std::string(paper_format)},
                            {"scene", report.scene},
                            {"seed", html::seed_text(report.seed)}});
  return html::page(title, body);
}

}  // namespace warpgrain::reports
