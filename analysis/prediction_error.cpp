#include "analysis/prediction_error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "analysis/statistics.hpp"
#include "core/error.hpp"

namespace warpgrain {

PredictionError prediction_error(std::span<const double> predicted, std::span<const double> measured) {
  if (predicted.size() != measured.size() || measured.empty())
    throw_input_error("prediction", fmt::format("{} and {} values", predicted.size(), measured.size()),
                      "as many of both, and one at least");
  std::vector<double> errors;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    if (!(measured[k] > 0))
      throw_input_error(fmt::format("measured value {}", k), fmt::format("{}", measured[k]), "above 0");
    errors.push_back(std::abs(predicted[k] / measured[k] - 1));
  }
  return {median(errors), std::ranges::max(errors)};
}

std::optional<LeftOut> leave_one_out(std::span<const double> predicted, std::span<const double> measured) {
  prediction_error(predicted, measured);  // refuses what has none
  if (measured.size() < 3) return std::nullopt;
  LeftOut range{{1, -1}, {HUGE_VAL, 0}};
  for (std::size_t out = 0; out < measured.size(); ++out) {
    std::vector<double> a(predicted.begin(), predicted.end()), b(measured.begin(), measured.end());
    a.erase(a.begin() + static_cast<std::ptrdiff_t>(out));
    b.erase(b.begin() + static_cast<std::ptrdiff_t>(out));
    const auto tau = kendall_tau(a, b);
    if (!tau) return std::nullopt;
    const double error = prediction_error(a, b).median;
    range.tau = {std::min(range.tau.lower, *tau), std::max(range.tau.upper, *tau)};
    range.median_error = {std::min(range.median_error.lower, error),
                          std::max(range.median_error.upper, error)};
  }
  return range;
}

}  // namespace warpgrain
