#include "reports/html/comparison_page.hpp"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>

#include "reports/html/charts.hpp"
#include "reports/html/page.hpp"
#include "reports/html/provenance.hpp"
#include "reports/html/table.hpp"
#include "reports/metrics.hpp"
#include "reports/number_text.hpp"

namespace warpgrain::reports {
namespace {

html::Cell value_cell_of(const std::string& metric, double value) {
  if (metric == "seconds") return {seconds_text(value), value, {}};
  const bool whole = value >= 0 && value < 1e18 && value == std::floor(value);
  return {whole ? count_text(static_cast<std::uint64_t>(value)) : fmt::format("{:.4g}", value), value, {}};
}

// As dark as the difference is large; half as much again is full.
html::Cell relative_cell(const std::optional<double>& relative) {
  if (!relative) return html::text_cell("from 0");
  return {fmt::format("{:+.2f} %", 100 * *relative), *relative, std::min(1.0, std::abs(*relative) / 0.5)};
}

std::string explanation_of(const std::string& key) {
  if (key == "seconds") return "measured: median; of a report those that the cost model predicts";
  for (const Metric& m : metrics())
    if (m.key == key) return html::explanation(m);
  return {};
}

std::string differences_html(const Comparison& comparison) {
  html::Table table({{"kernel", "matched by name, its launches together", true},
                     {"metric", "point at one for its definition", true},
                     {comparison.base, "the first document, or what was measured"},
                     {comparison.other, "the second document, or the report beside it"},
                     {"difference", "second / first - 1"}});
  html::DifferenceChart chart{comparison.base, comparison.other, {}};
  for (const Difference& d : comparison.differences) {
    html::Cell metric = html::text_cell(d.metric);
    metric.html =
        fmt::format("<span title=\"{}\">{}</span>", html::escape(explanation_of(d.metric)), metric.html);
    table.add_row({html::text_cell(d.kernel), metric, value_cell_of(d.metric, d.base),
                   value_cell_of(d.metric, d.other), relative_cell(d.relative())});
    chart.rows.push_back({d.kernel, d.metric, d.base, d.other});
  }
  std::string body =
      html::difference_chart("Kernel by kernel", chart) + "<h2>All differences</h2>\n" + table.html();
  const auto alone = [&](const std::vector<std::string>& kernels, const std::string& file) {
    if (!kernels.empty())
      body += fmt::format("<p>Only in {}: {}</p>\n", html::escape(file),
                          html::escape(fmt::format("{}", fmt::join(kernels, ", "))));
  };
  alone(comparison.only_in_base, comparison.base);
  alone(comparison.only_in_other, comparison.other);
  return body;
}

std::string order_summary(const OrderComparison& order) {
  std::string html = "<dl>\n";
  const auto entry = [&](const char* name, const std::string& text) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, html::escape(text));
  };
  std::string tau = order.tau ? fmt::format("{:.3f}", *order.tau) : "none";
  if (order.interval)
    tau += fmt::format("; 95 % of draws of the readings from {:.3f} to {:.3f}", order.interval->lower,
                       order.interval->upper);
  if (order.left_out)
    tau += fmt::format("; without any one variant {:.3f} to {:.3f}", order.left_out->tau.lower,
                       order.left_out->tau.upper);
  entry(order.by_time ? "Kendall's tau of predicted times" : "Kendall's tau of warp instructions", tau);
  if (order.error)
    entry("error of predicted times", fmt::format("median {:.1f} %, largest {:.1f} %",
                                                  100 * order.error->median, 100 * order.error->largest));
  return html + "</dl>\n";
}

std::string order_html(const OrderComparison& order) {
  html::Table table({{"variant", "the value of each axis", true},
                     {"warp instructions", html::explanation(metric("warp_instructions"))},
                     {"predicted step", "by the cost model, on the machine of the sweep"},
                     {"measured step", "median of the readings"},
                     {"difference", "predicted / measured - 1"}});
  html::XyChart chart;
  chart.series.push_back({"variants", false, {}});
  chart.x = "measured step [s]";
  chart.y = order.by_time ? "predicted step [s]" : "warp instructions";
  chart.diagonal = order.by_time;
  for (const OrderComparison::Row& row : order.rows) {
    html::Cell predicted = html::text_cell("-"), difference = predicted;
    if (row.predicted_seconds) {
      predicted = value_cell_of("seconds", *row.predicted_seconds);
      difference = relative_cell(*row.predicted_seconds / row.seconds - 1);
    }
    table.add_row({html::text_cell(row.variant), value_cell_of("", row.warp_instructions), predicted,
                   value_cell_of("seconds", row.seconds), difference});
    chart.series[0].points.push_back({row.seconds,
                                      order.by_time ? row.predicted_seconds.value() : row.warp_instructions,
                                      row.variant,
                                      {},
                                      {}});
  }
  return order_summary(order) +
         html::xy_chart(
             order.by_time ? "Predicted against measured" : "Warp instructions against measured time",
             chart) +
         "<h2>Variants</h2>\n" + table.html();
}

}  // namespace

std::string comparison_page(const Comparison& comparison) {
  const auto name = [](const std::string& file) { return std::filesystem::path(file).filename().string(); };
  const std::string title = fmt::format("{} beside {}", name(comparison.other), name(comparison.base));
  std::string body = fmt::format("<h1>{}</h1>\n", html::escape(title));
  body += comparison.order ? order_html(*comparison.order) : differences_html(comparison);
  body += html::provenance(
      comparison.generator, comparison.command_line,
      {{"format", std::string(comparison_format)}, {"first", comparison.base}, {"second", comparison.other}});
  return html::page(title, body);
}

}  // namespace warpgrain::reports
