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

constexpr std::string_view chart_mark = "<div class=\"chart\"";

// charts.js has a function for each kind.
std::string chart_of(std::string_view kind, std::string_view title, const ChartData& data) {
  const std::string json = data.dump(-1, ' ', false, ChartData::error_handler_t::replace);
  return fmt::format("<h3>{}</h3>\n{} data-kind=\"{}\" data-chart=\"{}\"></div>\n", escape(title), chart_mark,
                     kind, escape(json));
}

// Text that stands between CDATA's marks for readers of XML. What ends them stands in strings of the library,
// where it can be written in another way, and in comparisons, which a blank does not change.
std::string script_of(std::string_view text) {
  std::string script(text);
  for (std::size_t at = 0; (at = script.find("]]>", at)) != std::string::npos; at += 3)
    if (at > 0 && script[at - 1] == '"')
      script.replace(at + 2, 1, "\\x3e");
    else
      script.insert(at + 2, " ");
  return fmt::format("<script>//<![CDATA[\n{}\n//]]></script>\n", script);
}

ChartData number_or_null(const std::optional<double>& value) {
  return value ? ChartData(*value) : ChartData(nullptr);
}

}  // namespace

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

std::string chart_scripts(std::string_view body) {
  if (body.find(chart_mark) == std::string_view::npos && body.find("data-lanes=") == std::string_view::npos)
    return {};
  return echarts_script().empty() ? "" : script_of(echarts_script()) + script_of(asset("html/charts.js"));
}

}  // namespace warpgrain::reports::html
