#include "reports/accuracy_report.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "analysis/pareto.hpp"

namespace warpgrain::reports {
namespace {

// By one of cost_names; 0: there is none.
double step_cost(const AccuracyReport::Case& row, std::string_view name) {
  if (name == "bytes") return static_cast<double>(row.bytes);
  if (name == "seconds") return row.seconds.value_or(0);
  if (name == "predicted_seconds") return row.predicted_seconds.value_or(0);
  if (name == "measured_seconds") return row.measured_seconds.value_or(0);
  return static_cast<double>(row.warp_instructions);
}

// Errors whose first two digits are the same are the same: sums in another order differ by less.
double as_shown(double error) {
  if (!(error > 0) || !std::isfinite(error)) return error;
  const double unit = std::pow(10, std::floor(std::log10(error)) - 1);
  return unit * std::round(error / unit);
}

// Cost first, then errors; what failed before it was measured is the worst.
Costs costs_of(const AccuracyReport::Case& row) {
  constexpr double worst = std::numeric_limits<double>::infinity();
  const bool failed = !row.failure.empty();
  Costs costs{row.relative_cost > 0 ? row.relative_cost : worst};
  costs.push_back(row.force ? as_shown(row.force->root_mean_square) : failed ? worst : 0);
  costs.push_back(row.collision ? as_shown(std::max(row.collision->restitution, row.collision->spin))
                  : failed      ? worst
                                : 0);
  costs.push_back(!row.trajectory             ? (failed ? worst : 0)
                  : row.trajectory->parted_at ? -*row.trajectory->parted_at
                                              : -worst);
  double significant = 0;
  for (const AccuracyReport::Ensemble& quantity : row.ensemble)
    if (quantity.significant)
      significant = std::max(significant, std::abs(*quantity.difference / quantity.mean));
  costs.push_back(significant);
  return costs;
}

std::string ensemble_text(const AccuracyReport::Ensemble& quantity) {
  if (!quantity.difference) return {};
  const double reference = quantity.mean - *quantity.difference;
  const auto percent = [&](double value) { return 100 * std::abs(value / reference); };
  if (quantity.significant)
    return fmt::format(", {} {} by {:.2g} % (+- {:.2g} %)", quantity.quantity,
                       *quantity.difference > 0 ? "higher" : "lower", percent(*quantity.difference),
                       percent(quantity.difference_half_width.value_or(0)));
  if (!quantity.difference_half_width) return {};
  return fmt::format(", {} unchanged within {:.2g} %", quantity.quantity,
                     percent(std::abs(*quantity.difference) + *quantity.difference_half_width));
}

}  // namespace

std::string AccuracyReport::Case::name() const {
  return step_factor == 1 ? variant : fmt::format("{}, {:g} x step", variant, step_factor);
}

void rank_cases(AccuracyReport& report) {
  double unit = 0;
  for (AccuracyReport::Case& row : report.cases) {
    const double cost = step_cost(row, report.cost) / row.step_factor;
    if (unit == 0) unit = cost;
    row.relative_cost = unit > 0 ? cost / unit : 0;
  }
  std::vector<Costs> costs;
  for (const AccuracyReport::Case& row : report.cases) costs.push_back(costs_of(row));
  const auto by = dominated_by(costs);
  for (std::size_t k = 0; k < by.size(); ++k)
    if (by[k]) report.cases[k].dominated_by = report.cases[*by[k]].name();
}

std::string sentence_of(const AccuracyReport::Case& row) {
  std::string text = row.relative_cost > 0 ? fmt::format("costs {:.2f} x", row.relative_cost)
                                           : std::string("cost not known");
  if (row.force) text += fmt::format(", forces off by {:.2g} of the largest", row.force->maximum);
  if (row.collision)
    text += fmt::format(", restitution off by {:.2g}, spin by {:.2g}, rebound angle by {:.2g} degrees",
                        row.collision->restitution, row.collision->spin, row.collision->rebound_angle);
  if (row.trajectory)
    text += row.trajectory->parted_at
                ? fmt::format(", trajectories part after {:.3g} ms", 1e3 * *row.trajectory->parted_at)
                : fmt::format(", trajectories together for {:.3g} ms", 1e3 * row.trajectory->compared);
  for (const AccuracyReport::Ensemble& quantity : row.ensemble) text += ensemble_text(quantity);
  if (!row.failure.empty()) text += fmt::format("; ended with: {}", row.failure);
  return text;
}

}  // namespace warpgrain::reports
