#pragma once
// Charts of a page, drawn by ECharts in the reader's browser. Without it, where the build had no npm, pages
// have the tables alone.

#include <string>
#include <string_view>

#include "profiler/counters.hpp"
#include "reports/sweep_index.hpp"

namespace warpgrain::reports::html {

// The library's text; empty where the build had none.
std::string_view echarts_script();

// Cases of a sweep as points of any two columns, with those that no other beats in both; and as lines through
// all axes. Empty without ECharts or with fewer than two cases that are done.
std::string sweep_charts(const SweepIndex& index);

// SIMT efficiency by warp width, a line a policy and order; empty without ECharts or where one width was
// asked for.
std::string what_if_chart(const profiler::LaunchCounters& counters);

// What draws them, for the end of a page that has any; else empty.
std::string chart_scripts(std::string_view body);

}  // namespace warpgrain::reports::html
