#include "reports/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "analysis/statistics.hpp"
#include "core/error.hpp"
#include "reports/metrics.hpp"

namespace warpgrain::reports {
namespace {

// Those of the table, with what is no counter before them.
std::vector<std::string> metrics_in_order() {
  std::vector<std::string> keys{"launches", "seconds"};
  for (const Metric& metric : metrics()) keys.emplace_back(metric.key);
  return keys;
}

// A wish for a metric that nobody knows is a slip of the pen.
void require_known(std::span<const std::string> wanted) {
  const std::vector<std::string> known = metrics_in_order();
  const std::vector<std::string_view> valid(known.begin(), known.end());
  for (const std::string& metric : wanted)
    if (std::ranges::find(valid, metric) == valid.end())
      throw_unknown_name("--metric", "metric", metric, valid);
}

const KernelQuantities* find(const std::vector<KernelQuantities>& all, const std::string& kernel) {
  const auto found = std::ranges::find(all, kernel, &KernelQuantities::kernel);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::optional<double> Difference::relative() const {
  if (base == 0 && other == 0) return 0;
  return base == 0 ? std::nullopt : std::optional(other / base - 1);
}

Comparison compare(const std::vector<KernelQuantities>& base, const std::vector<KernelQuantities>& other,
                   std::span<const std::string> metrics) {
  require_known(metrics);
  Comparison comparison;
  for (const KernelQuantities& kernel : other) {
    const KernelQuantities* const in_base = find(base, kernel.kernel);
    if (in_base == nullptr) {
      comparison.only_in_other.push_back(kernel.kernel);
      continue;
    }
    for (const std::string& metric : metrics_in_order()) {
      const auto a = in_base->values.find(metric), b = kernel.values.find(metric);
      if (a == in_base->values.end() || b == kernel.values.end()) continue;
      if (!metrics.empty() && std::ranges::find(metrics, metric) == metrics.end()) continue;
      comparison.differences.push_back({kernel.kernel, metric, a->second, b->second});
    }
  }
  for (const KernelQuantities& kernel : base)
    if (find(other, kernel.kernel) == nullptr) comparison.only_in_base.push_back(kernel.kernel);
  return comparison;
}

OrderComparison compare_order(const SweepIndex& sweep, std::span<const MeasuredReport> measured) {
  OrderComparison order;
  std::vector<double> medians;
  std::vector<std::vector<double>> readings;
  for (const SweepCase& sweep_case : sweep.cases) {
    if (!sweep_case.headline) continue;
    const auto found = std::ranges::find_if(
        measured, [&](const MeasuredReport& m) { return m.step && m.variant == sweep_case.variant; });
    if (found == measured.end()) continue;
    readings.push_back(found->step->seconds);
    medians.push_back(median(found->step->seconds));
    order.rows.push_back({sweep_case.variant, static_cast<double>(sweep_case.headline->warp_instructions),
                          sweep_case.headline->predicted_seconds, medians.back()});
  }
  if (order.rows.size() < 2)
    throw_input_error("--measured",
                      fmt::format("measured steps of {} of the sweep's variants", order.rows.size()),
                      "of two or more");
  order.by_time =
      std::ranges::all_of(order.rows, [](const auto& row) { return row.predicted_seconds.has_value(); });
  std::vector<double> predicted;
  for (const OrderComparison::Row& row : order.rows)
    predicted.push_back(order.by_time ? *row.predicted_seconds : row.warp_instructions);
  order.tau = kendall_tau(predicted, medians);
  if (order.by_time) {
    order.error = prediction_error(predicted, medians);
    order.left_out = leave_one_out(predicted, medians);
  }
  if (std::ranges::all_of(readings, [](const auto& r) { return r.size() > 1; }))
    order.interval = kendall_interval(predicted, readings);
  return order;
}

double largest_difference(const Comparison& comparison) {
  double largest = 0;
  for (const Difference& difference : comparison.differences) {
    const auto relative = difference.relative();
    if (!relative) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, std::abs(*relative));
  }
  return largest;
}

}  // namespace warpgrain::reports
