#include "reports/html/sweep_page.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "reports/html/charts.hpp"
#include "reports/html/page.hpp"
#include "reports/html/provenance.hpp"
#include "reports/html/sweep_changes.hpp"
#include "reports/html/table.hpp"
#include "reports/number_text.hpp"
#include "reports/sweep_columns.hpp"

namespace warpgrain::reports {
namespace {

html::Cell variant_cell(const SweepCase& sweep_case) {
  const std::string name = fmt::format("<span class=\"mono\">{}</span>", html::escape(sweep_case.variant));
  if (!sweep_case.report_file) return {name, {}, {}};
  const std::string page = std::filesystem::path(*sweep_case.report_file).replace_extension(".html").string();
  return {fmt::format("<a href=\"{}\">{}</a>", html::escape(page), name), {}, {}};
}

// Each column is shaded from its best to its worst value.
html::Cell value_cell(const SweepColumn& column, const SweepCase& sweep_case, double smallest,
                      double largest) {
  const std::optional<double> value = column.value(sweep_case);
  html::Cell cell = html::text_cell(column.text(sweep_case));
  if (!value) return cell;
  cell.sort_by = value;
  if (largest > smallest)
    cell.heat = (column.higher_is_better ? largest - *value : *value - smallest) / (largest - smallest);
  return cell;
}

std::string explanation_of(const SweepColumn& column) {
  return column.metric.empty() ? std::string(column.explanation)
                               : html::explanation(column.explanation, column.metric);
}

html::Table table_of(const SweepIndex& index) {
  std::vector<html::Table::Column> columns{
      {"variant", "the value of each axis; opens the report of the case", true}};
  std::vector<std::pair<double, double>> ranges;  // one a column
  const std::vector<SweepColumn> shown = sweep_columns(index);
  for (const SweepColumn& column : shown) {
    columns.push_back({std::string(column.heading), explanation_of(column)});
    std::vector<double> values;
    for (const SweepCase& sweep_case : index.cases)
      if (const auto value = column.value(sweep_case)) values.push_back(*value);
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    ranges.emplace_back(values.empty() ? 0 : *low, values.empty() ? 0 : *high);
  }
  html::Table table(columns);
  for (const SweepCase& sweep_case : index.cases) {
    std::vector<html::Cell> row{variant_cell(sweep_case)};
    for (std::size_t c = 0; c < ranges.size(); ++c)
      row.push_back(value_cell(shown[c], sweep_case, ranges[c].first, ranges[c].second));
    table.add_row(row);
  }
  return table;
}

// A line a case.
std::string efficiency_over_time(const SweepIndex& index) {
  html::XyChart chart{"time [s]", "SIMT efficiency", {}, false, true};
  for (const SweepCase& sweep_case : index.cases) {
    if (sweep_case.samples.empty()) continue;
    html::XyChart::Series& line =
        chart.series.emplace_back(html::XyChart::Series{sweep_case.variant, true, {}});
    for (const SweepCase::Sample& sample : sweep_case.samples)
      line.points.push_back(
          {sample.time, sample.simt_efficiency, fmt::format("step {}", count_text(sample.step)), {}, {}});
  }
  return html::xy_chart("SIMT efficiency of a step, from falling to rest", chart);
}

std::string list_of(std::string_view heading, const std::vector<std::string>& lines) {
  if (lines.empty()) return {};
  std::string html = fmt::format("<h2>{}</h2>\n<ul>\n", heading);
  for (const std::string& line : lines) html += fmt::format("<li>{}</li>\n", html::escape(line));
  return html + "</ul>\n";
}

}  // namespace

std::string sweep_page(const SweepIndex& index, const SweepIndex* baseline) {
  const std::string title = title_of(index);
  std::string body = fmt::format(
      "<h1>{}</h1>\n<p class=\"soft\">Variant sweep; click a heading to sort, point at it for "
      "its meaning.</p>\n{}",
      html::escape(title), table_of(index).html());
  body += html::sweep_charts(index) + efficiency_over_time(index);
  if (baseline != nullptr) body += html::sweep_changes(index, *baseline);
  body += "<h2>Columns</h2>\n<dl>\n";
  for (const SweepColumn& column : sweep_columns(index))
    body += fmt::format("<dt>{}</dt><dd>{}</dd>\n", html::escape(column.heading),
                        html::escape(explanation_of(column)));
  body += "</dl>\n";
  body += list_of("Not done", troubles_of(index));
  body += list_of("Kernels and devices", notes_of(index));
  body += html::provenance(
      index.generator, index.command_line,
      {{"format", std::string(sweep_format)}, {"scene", index.scene}, {"seed", html::seed_text(index.seed)}});
  return html::page(title, body);
}

}  // namespace warpgrain::reports
