#include <algorithm>
#include <fmt/format.h>

#include "reports/html/page.hpp"
#include "reports/html/provenance.hpp"
#include "reports/html/table.hpp"
#include "reports/stability_report.hpp"

namespace warpgrain::reports {
namespace {

html::Cell heat_cell(const StabilityReport::Probe& probe, const StabilityReport::Cell& cell) {
  const bool is_right = cell.verdict == Verdict::right;
  html::Cell shown = html::text_cell(
      cell.verdict == Verdict::not_applicable ? "-"
      : is_right                              ? "right"
      : cell.right_until ? fmt::format("{:.2g}, {}", *cell.right_until, verdict_name(cell.verdict))
                         : fmt::format("nowhere, {}", verdict_name(cell.verdict)));
  shown.html =
      fmt::format("<span title=\"{}\">{}</span>", html::escape(limits_text(probe, cell)), shown.html);
  if (cell.verdict == Verdict::not_applicable) return shown;
  shown.sort_by = share_of_range(probe, cell);
  shown.heat = 1 - *shown.sort_by;
  return shown;
}

html::Table heat_map(const StabilityReport& report) {
  std::vector<html::Table::Column> columns{{"variant", "what was probed", true},
                                           {"back end", "where it was", true}};
  for (const StabilityReport::Probe& probe : report.probes)
    columns.push_back({probe.name, fmt::format("{}; {} from {:.3g} to {:.3g} {}", probe.summary,
                                               probe.parameter, probe.from, probe.to, probe.unit)});
  html::Table table(columns);
  std::vector<std::pair<std::string, std::string>> rows;
  for (const StabilityReport::Cell& cell : report.cells)
    if (const std::pair row{cell.variant, cell.backend}; std::ranges::find(rows, row) == rows.end())
      rows.push_back(row);
  for (const auto& [variant, backend] : rows) {
    std::vector<html::Cell> cells{html::text_cell(variant), html::text_cell(backend)};
    for (const StabilityReport::Probe& probe : report.probes) {
      const auto found = std::ranges::find_if(report.cells, [&](const StabilityReport::Cell& cell) {
        return cell.probe == probe.name && cell.variant == variant && cell.backend == backend;
      });
      cells.push_back(found == report.cells.end() ? html::text_cell("-") : heat_cell(probe, *found));
    }
    table.add_row(cells);
  }
  return table;
}

}  // namespace

std::string stability_page(const StabilityReport& report) {
  std::string body = fmt::format(
      "<h1>Where each variant stops being right</h1>\n<p class=\"soft\">How far each parameter can go; the "
      "stronger the shade, the sooner it fails. Point at a cell for what happens there, at a heading for the "
      "probe.</p>\n{}<h2>Probes</h2>\n<dl>\n",
      heat_map(report).html());
  for (const StabilityReport::Probe& probe : report.probes)
    body += fmt::format("<dt>{}</dt><dd>{}; {}</dd>\n", html::escape(probe.name), html::escape(probe.summary),
                        html::escape(probe.invariant));
  body += "</dl>\n" + html::provenance(report.generator, report.command_line,
                                       {{"format", std::string(stability_format)}});
  return html::page("Stability", body);
}

}  // namespace warpgrain::reports
