#include "analysis/force_error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace warpgrain {
namespace {

VectorError vector_error(const std::vector<std::uint32_t>& id, std::string_view quantity,
                         const std::vector<Vector3d>& measured, const std::vector<Vector3d>& reference) {
  const std::size_t n = id.size();
  if (measured.size() != n || reference.size() != n)
    throw_input_error(fmt::format("{} error", quantity),
                      fmt::format("{} measured and {} reference vectors", measured.size(), reference.size()),
                      fmt::format("{} of each, one a particle", n));
  VectorError error;
  double sum_of_squares = 0, largest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (!measured[k].allFinite() || !reference[k].allFinite())
      throw_input_error(fmt::format("{} on particle {}", quantity, id[k]), "not a finite number");
    error.scale = std::max(error.scale, reference[k].norm());
    const double difference = (measured[k] - reference[k]).norm();
    sum_of_squares += difference * difference;
    if (difference > largest) {
      largest = difference;
      error.worst_particle = id[k];
    }
  }
  if (largest == 0) return error;
  if (error.scale == 0)
    throw_input_error(fmt::format("{} error", quantity),
                      "the reference is zero everywhere, the measured is not");
  error.maximum = largest / error.scale;
  error.root_mean_square = std::sqrt(sum_of_squares / static_cast<double>(n)) / error.scale;
  return error;
}

}  // namespace

ForceError force_error(const ParticleState& state, const ForceState& measured, const ForceState& reference) {
  return {vector_error(state.id, "force", measured.force, reference.force),
          vector_error(state.id, "torque", measured.torque, reference.torque)};
}

}  // namespace warpgrain
