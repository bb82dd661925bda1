#include "reports/html/charts.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>

#include "reports/html/page.hpp"
#include "reports/html/table.hpp"
#include "reports/summary.hpp"
#include "reports/sweep_columns.hpp"

namespace warpgrain::reports::html {
namespace {

using ChartData = nlohmann::ordered_json;

// The scripts have a function for each kind.
std::string chart_of(std::string_view kind, std::string_view title, const ChartData& data) {
  const std::string json = data.dump(-1, ' ', false, ChartData::error_handler_t::replace);
  return fmt::format(
      "<h3>{0}</h3>\n<div class=\"scroll\"><div class=\"chart\" data-title=\"{0}\" data-kind=\"{1}\" "
      "data-chart=\"{2}\"></div></div>\n",
      escape(title), kind, escape(json));
}

ChartData number_or_null(const std::optional<double>& value) {
  return value ? ChartData(*value) : ChartData(nullptr);
}

}  // namespace

std::string trade_off_chart(std::string_view title, const TradeOff& trade_off) {
  if (echarts_script().empty() || trade_off.names.size() < 2 || trade_off.columns.empty()) return {};
  ChartData data{
      {"names", trade_off.names}, {"x", trade_off.x}, {"y", trade_off.y}, {"columns", ChartData::array()}};
  for (const TradeOff::Column& column : trade_off.columns) {
    ChartData values = ChartData::array();
    for (const std::optional<double>& value : column.values) values.push_back(number_or_null(value));
    data["columns"].push_back(
        {{"name", column.name}, {"higher_is_better", column.higher_is_better}, {"values", values}});
  }
  if (!trade_off.beaten.empty()) data["beaten"] = trade_off.beaten;
  return chart_of("trade_off", title, data);
}

std::string xy_chart(std::string_view title, const XyChart& chart) {
  ChartData data{{"x", chart.x},
                 {"y", chart.y},
                 {"diagonal", chart.diagonal},
                 {"from_zero", chart.from_zero},
                 {"series", ChartData::array()}};
  bool any = false;
  for (const XyChart::Series& series : chart.series) {
    ChartData points = ChartData::array();
    for (const XyChart::Point& point : series.points) {
      ChartData drawn{{"x", point.x}, {"y", point.y}};
      if (!point.label.empty()) drawn["label"] = point.label;
      if (point.low && point.high) {
        drawn["low"] = *point.low;
        drawn["high"] = *point.high;
      }
      points.push_back(drawn);
    }
    any = any || !points.empty();
    data["series"].push_back({{"name", series.name}, {"line", series.line}, {"points", points}});
  }
  return any && !echarts_script().empty() ? chart_of("xy", title, data) : "";
}

std::string bar_chart(std::string_view title, const BarChart& chart) {
  if (echarts_script().empty() || chart.names.empty()) return {};
  ChartData data{
      {"names", chart.names}, {"value", chart.value}, {"log", chart.log}, {"series", ChartData::array()}};
  for (const BarChart::Series& series : chart.series) {
    ChartData values = ChartData::array();
    for (const std::optional<double>& value : series.values) values.push_back(number_or_null(value));
    data["series"].push_back({{"name", series.name}, {"values", values}});
  }
  return chart_of("bars", title, data);
}

std::string interval_chart(std::string_view title, const IntervalChart& chart) {
  if (echarts_script().empty() || chart.points.empty()) return {};
  ChartData data{
      {"value", chart.value}, {"reference", number_or_null(chart.reference)}, {"points", ChartData::array()}};
  for (const IntervalChart::Point& point : chart.points)
    data["points"].push_back({{"name", point.name},
                              {"mean", point.mean},
                              {"low", point.low},
                              {"high", point.high},
                              {"marked", point.marked}});
  return chart_of("intervals", title, data);
}

std::string difference_chart(std::string_view title, const DifferenceChart& chart) {
  if (echarts_script().empty() || chart.rows.empty()) return {};
  ChartData data{{"base", chart.base}, {"other", chart.other}, {"rows", ChartData::array()}};
  for (const DifferenceChart::Row& row : chart.rows)
    data["rows"].push_back(
        {{"kernel", row.kernel}, {"metric", row.metric}, {"base", row.base}, {"other", row.other}});
  return chart_of("differences", title, data);
}

std::string sweep_charts(const SweepIndex& index) {
  std::vector<const SweepCase*> done;
  for (const SweepCase& sweep_case : index.cases)
    if (sweep_case.status == CaseStatus::done) done.push_back(&sweep_case);
  if (echarts_script().empty() || done.size() < 2) return {};

  ChartData data{
      {"names", ChartData::array()}, {"axes", ChartData::array()}, {"columns", ChartData::array()}};
  std::set<std::string> axes;
  for (const SweepCase* sweep_case : done) {
    data["names"].push_back(sweep_case->variant);
    for (const auto& [axis, value] : sweep_case->axes) axes.insert(axis);
  }
  for (const std::string& axis : axes) {
    ChartData values = ChartData::array();
    for (const SweepCase* sweep_case : done) {
      const auto found = sweep_case->axes.find(axis);
      values.push_back(found == sweep_case->axes.end() ? "" : found->second);
    }
    data["axes"].push_back({{"name", axis}, {"values", values}});
  }
  for (const SweepColumn& column : sweep_columns(index)) {
    ChartData values = ChartData::array();
    for (const SweepCase* sweep_case : done) values.push_back(number_or_null(column.value(*sweep_case)));
    if (std::ranges::all_of(values, [](const ChartData& value) { return value.is_null(); })) continue;
    data["columns"].push_back(
        {{"name", column.heading}, {"higher_is_better", column.higher_is_better}, {"values", values}});
  }
  return chart_of("trade_off", "One against another: the line joins variants that no other beats in both",
                  data) +
         chart_of("parallel", "All axes: drag along an axis to pick variants", data);
}

std::string what_if_chart(const profiler::LaunchCounters& counters) {
  std::set<std::uint32_t> widths{counters.warp_width};
  ChartData data{{"widths", ChartData::array()}, {"points", ChartData::array()}};
  const auto add = [&](const std::string& series, std::uint32_t width, const profiler::Totals& totals) {
    data["points"].push_back({{"series", series},
                              {"width", width},
                              {"efficiency", totals.simt_efficiency(width)},
                              {"instructions", totals.warp_instructions}});
  };
  add("the run", counters.warp_width, counters.totals);
  for (const profiler::WhatIfTotals& answer : counters.what_if) {
    widths.insert(answer.warp_width);
    add(fmt::format("{}, {}", policy_text(answer), answer.order), answer.warp_width, answer.totals);
  }
  if (echarts_script().empty() || widths.size() < 2) return {};
  for (const std::uint32_t width : widths) data["widths"].push_back(width);
  return chart_of("what_if", "SIMT efficiency by warp width", data);
}

}  // namespace warpgrain::reports::html
