#include "variants/half_history.hpp"

#include <Eigen/Core>
#include <cmath>
#include <fmt/format.h>

namespace warpgrain {

HalfHistory::HalfHistory(double smallest_radius)
    : unit_exponent_(static_cast<int>(std::ceil(std::log2(smallest_radius))) - 15) {}

bool HalfHistory::can_store(const Vector3d& displacement) const {
  return std::ldexp(displacement.cwiseAbs().maxCoeff(), -unit_exponent_) <= 65504;
}

std::vector<std::byte> HalfHistory::stored(const std::vector<Vector3d>& displacements) const {
  std::vector<Eigen::half> halves;
  halves.reserve(3 * displacements.size());
  for (const Vector3d& v : displacements)
    for (const double component : v) halves.emplace_back(std::ldexp(component, -unit_exponent_));
  const auto bytes = std::as_bytes(std::span(halves));
  return {bytes.begin(), bytes.end()};
}

std::vector<double> HalfHistory::lengths(std::span<const std::uint16_t> halves) const {
  std::vector<double> lengths;
  lengths.reserve(halves.size());
  for (const std::uint16_t bits : halves)
    lengths.push_back(
        std::ldexp(double{static_cast<float>(Eigen::numext::bit_cast<Eigen::half>(bits))}, unit_exponent_));
  return lengths;
}

std::string HalfHistory::build_options() const {
  return fmt::format("-D HALF_HISTORY -D HISTORY_UNIT=0x1p{}f", unit_exponent_);
}

}  // namespace warpgrain
