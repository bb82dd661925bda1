#include "analysis/confidence.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain {
namespace {

struct Moments {
  double count = 0, mean = 0, variance_of_mean = 0;
};

Moments moments_of(std::span<const double> values) {
  if (values.empty()) throw_input_error("confidence interval", "no values", "at least one");
  Moments moments;
  moments.count = static_cast<double>(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k]))
      throw_input_error(fmt::format("value {}", k), fmt::format("{}", values[k]), "a finite number");
    moments.mean += values[k] / moments.count;
  }
  double squares = 0;
  for (const double value : values) squares += (value - moments.mean) * (value - moments.mean);
  if (values.size() > 1) moments.variance_of_mean = squares / (moments.count - 1) / moments.count;
  return moments;
}

double half_width(double variance_of_mean, double degrees_of_freedom, std::size_t comparisons = 1) {
  if (variance_of_mean == 0) return 0;
  const double beyond = 0.025 / static_cast<double>(comparisons);
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), 1 - beyond) *
         std::sqrt(variance_of_mean);
}

}  // namespace

MeanInterval mean_interval(std::span<const double> values) {
  const Moments moments = moments_of(values);
  MeanInterval interval{values.size(), moments.mean, {}};
  if (values.size() > 1) interval.half_width = half_width(moments.variance_of_mean, moments.count - 1);
  return interval;
}

MeanInterval difference_of_means(std::span<const double> a, std::span<const double> b,
                                 std::size_t comparisons) {
  const Moments of_a = moments_of(a), of_b = moments_of(b);
  MeanInterval interval{std::min(a.size(), b.size()), of_a.mean - of_b.mean, {}};
  if (interval.count < 2) return interval;
  const double variance = of_a.variance_of_mean + of_b.variance_of_mean;
  // Welch & Satterthwaite
  const double spread = of_a.variance_of_mean * of_a.variance_of_mean / (of_a.count - 1) +
                        of_b.variance_of_mean * of_b.variance_of_mean / (of_b.count - 1);
  interval.half_width = spread > 0 ? half_width(variance, variance * variance / spread, comparisons) : 0;
  return interval;
}

bool is_significant(const MeanInterval& difference) {
  return difference.half_width && std::abs(difference.mean) > *difference.half_width;
}

}  // namespace warpgrain
