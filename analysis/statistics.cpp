#include "analysis/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "core/error.hpp"

namespace warpgrain {
namespace {

std::vector<double> sorted(std::span<const double> readings) {
  if (readings.empty()) throw_input_error("statistics", "no readings", "at least one");
  for (std::size_t k = 0; k < readings.size(); ++k)
    if (std::isnan(readings[k])) throw_input_error(fmt::format("reading {}", k), "NaN", "a number");
  std::vector<double> values(readings.begin(), readings.end());
  std::sort(values.begin(), values.end());
  return values;
}

double percentile_of_sorted(const std::vector<double>& values, double percent) {
  if (!(percent >= 0 && percent <= 100))
    throw_input_error("percentile", fmt::format("{}", percent), "a number from 0 to 100");
  const double place = percent / 100 * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 == values.size()) return values.back();
  return std::lerp(values[below], values[below + 1], place - static_cast<double>(below));
}

}  // namespace

double percentile(std::span<const double> readings, double percent) {
  return percentile_of_sorted(sorted(readings), percent);
}

double median(std::span<const double> readings) { return percentile(readings, 50); }

double Spread::relative_spread() const {
  return median == 0 ? 0 : (upper_quartile - lower_quartile) / median;
}

Spread spread_of(std::span<const double> readings) {
  const std::vector<double> values = sorted(readings);
  return {.readings = values.size(),
          .minimum = values.front(),
          .lower_quartile = percentile_of_sorted(values, 25),
          .median = percentile_of_sorted(values, 50),
          .upper_quartile = percentile_of_sorted(values, 75),
          .maximum = values.back()};
}

}  // namespace warpgrain
