#include "analysis/convergence.hpp"

#include <cmath>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain {

std::optional<double> convergence_order(std::span<const double> results) {
  if (results.size() < 3)
    throw_input_error("convergence", fmt::format("{} results", results.size()), "three or more");
  double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (!std::isfinite(results[k]))
      throw_input_error(fmt::format("result {}", k), fmt::format("{}", results[k]), "a finite number");
    if (k + 1 == results.size()) break;
    const double error = std::abs(results[k] - results.back());
    if (error == 0) continue;
    const double x = -static_cast<double>(k), y = std::log2(error);
    n += 1;
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  if (n < 2) return {};
  return (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

}  // namespace warpgrain
