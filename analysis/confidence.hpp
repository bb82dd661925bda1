#pragma once
// What a few repeated simulations say about a mean, and about the difference of two.

#include <optional>
#include <span>

namespace warpgrain {

struct MeanInterval {
  std::size_t count = 0;
  double mean = 0;
  // Half of the 95 % confidence interval by Student's t; none of a single value, which says nothing of its
  // spread.
  std::optional<double> half_width;
};

// Throws InputError when there is no value or one is not finite.
MeanInterval mean_interval(std::span<const double> values);

// The mean of a less the mean of b with its 95 % interval by Welch's t test, for values that have nothing to
// do with each other one by one (two simulations of the same seed part after some collisions). Of several
// comparisons that are judged together the interval is wider, so that with 95 % none of them claims a
// difference where there is none (Bonferroni).
MeanInterval difference_of_means(std::span<const double> a, std::span<const double> b,
                                 std::size_t comparisons = 1);

// Whether zero lies outside of the interval; not without an interval.
bool is_significant(const MeanInterval& difference);

}  // namespace warpgrain
