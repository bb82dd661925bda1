#pragma once
// The metrics of a report: one table behind `warpgrain list metrics`, the pages and docs/report-format.md.

#include <span>
#include <string_view>

namespace warpgrain::reports {

struct Metric {
  std::string_view key;    // in "warpgrain.report/1", or how it follows from keys
  std::string_view label;  // a short heading for people
  std::string_view unit;
  std::string_view definition;
  std::string_view ncu_metric;  // Nsight Compute's name; empty where it has none
};

std::span<const Metric> metrics();
// The metric of that key, which must be in the table.
const Metric& metric(std::string_view key);

}  // namespace warpgrain::reports
