#pragma once
// Order statistics of repeated readings. Timings of a shared machine have a long upper tail, so the median
// stands for the reading and the percentiles beside it say how far it can be trusted; a mean would be
// neither.

#include <cstddef>
#include <span>

namespace warpgrain {

// The value below which `percent` (0 to 100) of the readings lie, linearly interpolated between the sorted
// readings (Hyndman & Fan's type 7, the default of R and NumPy). Throws InputError when there is no reading,
// when one is NaN or when `percent` is outside its range.
double percentile(std::span<const double> readings, double percent);

double median(std::span<const double> readings);

struct Spread {
  std::size_t readings = 0;
  double minimum = 0, lower_quartile = 0, median = 0, upper_quartile = 0, maximum = 0;
  // Interquartile range / median: how noisy the readings are; 0 when the median is 0.
  double relative_spread() const;
};

Spread spread_of(std::span<const double> readings);

}  // namespace warpgrain
