#pragma once
// How fast a result settles as steps become smaller.

#include <optional>
#include <span>

namespace warpgrain {

// The order p of |result - limit| ~ step^p: the slope of the line of least squares through the logarithms.
// `results` belong to steps each half of the one before, but for the last, which is finer by far and stands
// for the limit, [n >= 3]. None where the results do not differ. Throws InputError for fewer, or what is not
// finite.
std::optional<double> convergence_order(std::span<const double> results);

}  // namespace warpgrain
