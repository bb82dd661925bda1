#pragma once
// Which of several choices nothing else beats.

#include <optional>
#include <span>
#include <vector>

namespace warpgrain {

// Costs of one choice, each the less the better, [criteria].
using Costs = std::vector<double>;

// For each choice the first one that dominates it: at most as much in every criterion, less in one. None for
// those of the front. Throws InputError when their lengths differ or a number is NaN; infinity is the worst.
std::vector<std::optional<std::size_t>> dominated_by(std::span<const Costs> choices);

}  // namespace warpgrain
