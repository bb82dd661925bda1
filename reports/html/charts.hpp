#pragma once
// Charts of a page, drawn by ECharts in the reader's browser. Without it, where the build had no npm, pages
// have the tables alone. Each function is empty without ECharts and where there is nothing to draw.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "profiler/counters.hpp"
#include "reports/sweep_index.hpp"

namespace warpgrain::reports::html {

// The library's text; empty where the build had none.
std::string_view echarts_script();

// Variants as points of any two columns that the reader picks, with those that no other beats in both.
struct TradeOff {
  struct Column {
    std::string name;
    bool higher_is_better = false;
    std::vector<std::optional<double>> values;  // [names]
  };
  std::vector<std::string> names;
  std::vector<Column> columns;
  std::string x, y;          // what is picked first: columns whose names have these words
  std::vector<bool> beaten;  // drawn hollow; empty: none
};
std::string trade_off_chart(std::string_view title, const TradeOff& trade_off);

// Points or lines over two axes; an axis that spans more than a factor of 20 is logarithmic.
struct XyChart {
  struct Point {
    double x = 0, y = 0;
    std::string label = {};
    std::optional<double> low = {}, high = {};  // of an interval of y
  };
  struct Series {
    std::string name;
    bool line = false;
    std::vector<Point> points;
  };
  std::string x, y;  // what stands at the axes
  std::vector<Series> series;
  bool diagonal = false;   // where both are equal; the axes span the same
  bool from_zero = false;  // y begins at 0
};
std::string xy_chart(std::string_view title, const XyChart& chart);

// A bar a name in each series.
struct BarChart {
  struct Series {
    std::string name;
    std::vector<std::optional<double>> values;  // [names]
  };
  std::vector<std::string> names;
  std::string value;  // what stands at the axis
  std::vector<Series> series;
  bool log = false;
};
std::string bar_chart(std::string_view title, const BarChart& chart);

// A mean a row with its interval; hot where it is marked.
struct IntervalChart {
  struct Point {
    std::string name;
    double mean = 0, low = 0, high = 0;
    bool marked = false;
  };
  std::string value;  // what stands at the axis
  std::optional<double> reference;
  std::vector<Point> points;
};
std::string interval_chart(std::string_view title, const IntervalChart& chart);

// Two values of each kernel, of one metric that the reader picks.
struct DifferenceChart {
  struct Row {
    std::string kernel, metric;
    double base = 0, other = 0;
  };
  std::string base, other;
  std::vector<Row> rows;
};
std::string difference_chart(std::string_view title, const DifferenceChart& chart);

// Cases of a sweep as points of any two columns, with those that no other beats in both; and as lines through
// all axes. Empty with fewer than two cases that are done.
std::string sweep_charts(const SweepIndex& index);

// SIMT efficiency by warp width, a line a policy and order; empty where one width was asked for.
std::string what_if_chart(const profiler::LaunchCounters& counters);

}  // namespace warpgrain::reports::html
