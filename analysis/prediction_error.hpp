#pragma once
// How near predicted times come to measured ones.

#include <span>

#include "analysis/rank_correlation.hpp"

namespace warpgrain {

// |predicted / measured - 1| over the things.
struct PredictionError {
  double median = 0, largest = 0;
};

// Throws InputError when the lengths differ, there is nothing, or a measured value is not above 0.
PredictionError prediction_error(std::span<const double> predicted, std::span<const double> measured);

// What remains when any one thing is left out: the lowest and the highest of the values. A figure that hangs
// on a single thing shows by a wide range.
struct LeftOut {
  TauInterval tau;
  TauInterval median_error;
};

// Nothing with fewer than three things, or where a remainder orders no pair. Throws as prediction_error.
std::optional<LeftOut> leave_one_out(std::span<const double> predicted, std::span<const double> measured);

}  // namespace warpgrain
