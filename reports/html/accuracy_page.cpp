#include "reports/html/accuracy_page.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

#include "reports/html/charts.hpp"
#include "reports/html/page.hpp"
#include "reports/html/provenance.hpp"
#include "reports/html/table.hpp"
#include "reports/number_text.hpp"

namespace warpgrain::reports {
namespace {

using Case = AccuracyReport::Case;

// What a case is judged by: a column of the table and an axis of the chart.
struct Criterion {
  const char* name;
  const char* explanation;
  bool higher_is_better;
  std::function<std::optional<double>(const Case&)> value;
  std::function<std::string(double)> text;
};

std::string scientific(double value) { return fmt::format("{:.1e}", value); }

template <class Part>
auto member_of(std::optional<Part> Case::*part, double Part::*member) {
  return [part, member](const Case& row) {
    return row.*part ? std::optional((*(row.*part)).*member) : std::nullopt;
  };
}

std::vector<Criterion> criteria_of(const AccuracyReport& report) {
  const auto particles = static_cast<double>(
      std::max<std::uint64_t>(1, report.cost_particles != 0 ? report.cost_particles : report.particles));
  const auto fixed = [](int decimals) {
    return [decimals](double value) { return fixed_text(value, decimals); };
  };
  std::vector<Criterion> all{
      {"cost", "for the same time simulated, in the first case's", false,
       [](const Case& row) {
         return row.relative_cost > 0 ? std::optional(row.relative_cost) : std::nullopt;
       },
       fixed(2)},
      {"bytes/particle", "of the memory sectors that a step touches", false,
       [particles](const Case& row) { return static_cast<double>(row.bytes) / particles; }, fixed(0)},
      {"time/step", "median wall time of a step on the OpenCL device", false,
       [](const Case& row) { return row.seconds; }, seconds_text},
      {"predicted step", "by the cost model, on the machine", false,
       [](const Case& row) { return row.predicted_seconds; }, seconds_text},
      {"measured step", "read from documents of measurements", false,
       [](const Case& row) { return row.measured_seconds; }, seconds_text},
      {"force error, largest", "of one evaluation against the double reference, of the largest force", false,
       member_of(&Case::force, &AccuracyReport::Force::maximum), scientific},
      {"force error, rms", "the same, root mean square over the particles", false,
       member_of(&Case::force, &AccuracyReport::Force::root_mean_square), scientific},
      {"restitution error", "of one collision, as a part of the speed of impact", false,
       member_of(&Case::collision, &AccuracyReport::Collision::restitution), scientific},
      {"rebound angle error", "of one collision, in degrees", false,
       member_of(&Case::collision, &AccuracyReport::Collision::rebound_angle), scientific},
      {"spin error", "surface speed behind one collision, as a part of the speed of impact", false,
       member_of(&Case::collision, &AccuracyReport::Collision::spin), scientific},
      {"trajectories part at",
       "when particles are a radius away from the reference's; as long as was compared where they are not",
       true,
       [](const Case& row) {
         return row.trajectory ? std::optional(row.trajectory->parted_at.value_or(row.trajectory->compared))
                               : std::nullopt;
       },
       seconds_text}};
  std::erase_if(all, [&](const Criterion& criterion) {
    return std::ranges::none_of(report.cases,
                                [&](const Case& row) { return criterion.value(row).has_value(); });
  });
  return all;
}

std::string front_chart(const AccuracyReport& report, const std::vector<Criterion>& criteria) {
  html::TradeOff chart;
  chart.x = "cost";
  chart.y = "force error, rms";
  for (const Criterion& criterion : criteria)
    chart.columns.push_back({criterion.name, criterion.higher_is_better, {}});
  for (const Case& row : report.cases) {
    chart.names.push_back(row.name());
    chart.beaten.push_back(row.dominated_by.has_value());
    for (std::size_t k = 0; k < criteria.size(); ++k)
      chart.columns[k].values.push_back(criteria[k].value(row));
  }
  return html::trade_off_chart(
      "Cost against error: filled points are beaten by no other in every criterion; the line joins those "
      "that no other beats in the two that are shown",
      chart);
}

// A variant's name, where there is little room.
html::Cell broken_at_slashes(std::string_view name) {
  std::string text;
  for (const char c : html::escape(name)) text.append(1, c).append(c == '/' ? "<wbr/>" : "");
  return {fmt::format("<span class=\"mono wrap\">{}</span>", text), {}, {}};
}

std::string cases_table(const AccuracyReport& report, const std::vector<Criterion>& criteria) {
  std::vector<html::Table::Column> columns{
      {"variant", "with its time step in the scene's, where that is another", true},
      {"on", "the back end that errors are from", true}};
  for (const Criterion& criterion : criteria) columns.push_back({criterion.name, criterion.explanation});
  columns.push_back(
      {"dominated by",
       "the case that is at most as costly and as far off in every criterion, and less so in one", true});
  html::Table table(columns);
  for (const Case& row : report.cases) {
    html::Cell name = html::text_cell(row.name());
    name.html = fmt::format("<span class=\"mono\">{}</span>", name.html);
    std::vector<html::Cell> cells{name, html::text_cell(row.backend)};
    for (const Criterion& criterion : criteria) {
      const std::optional<double> value = criterion.value(row);
      html::Cell cell = html::text_cell(value ? criterion.text(*value) : "-");
      cell.sort_by = value;
      cells.push_back(cell);
    }
    cells.push_back(broken_at_slashes(row.dominated_by.value_or("")));
    table.add_row(cells);
  }
  return "<h2>Every case</h2>\n" + table.html();
}

std::string sentences(const AccuracyReport& report) {
  std::string html = "<h2>In words</h2>\n<ul>\n";
  for (const Case& row : report.cases)
    html += fmt::format("<li><span class=\"mono\">{}</span>: {}{}</li>\n", html::escape(row.name()),
                        html::escape(sentence_of(row)),
                        row.dominated_by ? fmt::format("; <span class=\"soft\">dominated by {}</span>",
                                                       html::escape(*row.dominated_by))
                                         : "");
  return html + "</ul>\n";
}

// A chart a quantity: the mean over the seeds of each case with its interval.
std::string ensembles(const AccuracyReport& report) {
  std::vector<html::IntervalChart> charts;
  std::vector<std::string> titles;
  for (const Case& row : report.cases)
    for (const AccuracyReport::Ensemble& quantity : row.ensemble) {
      const std::string value = quantity.unit.empty()
                                    ? quantity.quantity
                                    : fmt::format("{} [{}]", quantity.quantity, quantity.unit);
      auto known = std::ranges::find(charts, value, &html::IntervalChart::value);
      if (known == charts.end()) known = charts.insert(known, {value, {}, {}});
      const double reach = quantity.half_width.value_or(0);
      if (!quantity.difference) known->reference = quantity.mean;
      known->points.push_back(
          {row.name(), quantity.mean, quantity.mean - reach, quantity.mean + reach, quantity.significant});
    }
  if (charts.empty()) return {};
  std::string html = fmt::format(
      "<h2>Ensembles</h2>\n<p class=\"soft\">Means over {} seeds with their 95 % intervals; hot: parted from "
      "the reference beyond both "
      "intervals. The dashed line is the reference's mean.</p>\n",
      report.seeds);
  for (const html::IntervalChart& chart : charts) html += html::interval_chart(chart.value, chart);
  html::Table table(
      {{"variant", "the case", true},
       {"quantity", "a mean over time and grains of one box", true},
       {"mean", "over the seeds"},
       {"interval", "half the 95 % interval"},
       {"difference", "of the mean from the reference's"},
       {"its interval", "half the 95 % interval"},
       {"significant", "whether the difference is beyond what the seeds explain, by Welch's test", true}});
  const auto number = [](const std::optional<double>& value) {
    html::Cell cell = html::text_cell(value ? fmt::format("{:.4g}", *value) : "-");
    cell.sort_by = value;
    return cell;
  };
  for (const Case& row : report.cases)
    for (const AccuracyReport::Ensemble& quantity : row.ensemble)
      table.add_row({html::text_cell(row.name()), html::text_cell(quantity.quantity), number(quantity.mean),
                     number(quantity.half_width), number(quantity.difference),
                     number(quantity.difference_half_width),
                     html::text_cell(quantity.significant ? "yes" : "")});
  return html + table.html();
}

}  // namespace

std::string accuracy_page(const AccuracyReport& report) {
  const std::vector<Criterion> criteria = criteria_of(report);
  std::string body =
      fmt::format("<h1>What speed costs in accuracy</h1>\n<p class=\"soft\">{}, {} particles, step {}</p>\n",
                  html::escape(report.scene), count_text(report.particles), count_text(report.step));
  body +=
      front_chart(report, criteria) + cases_table(report, criteria) + sentences(report) + ensembles(report);
  body += html::provenance(
      report.generator, report.command_line,
      {{"format", std::string(accuracy_format)},
       {"time step", fmt::format("{:g} s", report.time_step)},
       {"cost", report.cost},
       {"costs counted of",
        report.cost_particles != 0 ? count_text(report.cost_particles) + " particles" : ""},
       {"machine", report.machine},
       {"measured", report.measured},
       {"seed", html::seed_text(report.seed)},
       {"seeds of the ensembles", report.seeds > 0 ? fmt::format("1 to {}", report.seeds) : ""}});
  return html::page("Accuracy", body);
}

}  // namespace warpgrain::reports
