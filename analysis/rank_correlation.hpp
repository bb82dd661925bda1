#pragma once
// Whether two quantities put the same things in the same order.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace warpgrain {

// Kendall's tau-b of two lists of the same length: 1 where they order all pairs alike, -1 where all the other
// way round; ties count for neither (M. G. Kendall, "Rank Correlation Methods", 1948). Nothing where one of
// the lists orders no pair. Throws InputError when the lengths differ or a value is NaN.
std::optional<double> kendall_tau(std::span<const double> a, std::span<const double> b);

struct TauInterval {
  double lower = 0, upper = 0;
};

// How far tau can be trusted for all that the readings scatter: 2.5th and 97.5th percentile of tau over 1000
// draws, each of which takes one of its readings for every thing. `readings`: [things][repeats]. Nothing
// where a draw orders no pair. Throws InputError when the lengths differ or there is no reading of a thing.
std::optional<TauInterval> kendall_interval(std::span<const double> predicted,
                                            std::span<const std::vector<double>> readings,
                                            std::uint64_t seed = 1);

}  // namespace warpgrain
