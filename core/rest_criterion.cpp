#include "core/rest_criterion.hpp"

#include <algorithm>
#include <cmath>

namespace warpgrain {

RestCriterion::RestCriterion(const RunEnd::AtRest& limits, std::uint64_t step,
                             std::span<const Vector3d> positions)
    : limits_(limits), window_begin_(step), begin_positions_(positions.begin(), positions.end()) {}

bool RestCriterion::update(std::uint64_t step, std::span<const Vector3d> positions) {
  double squared = 0;
  for (std::size_t k = 0; k < positions.size(); ++k)
    squared = std::max(squared, (positions[k] - begin_positions_[k]).squaredNorm());
  displacement_ = std::sqrt(squared);
  if (displacement_ > limits_.displacement) {
    window_begin_ = step;
    begin_positions_.assign(positions.begin(), positions.end());
    return false;
  }
  return step - window_begin_ >= limits_.window;
}

}  // namespace warpgrain
