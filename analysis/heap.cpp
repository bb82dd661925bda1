#include "analysis/heap.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "core/error.hpp"

namespace warpgrain {
namespace {

double time_of(std::span<const PassedAt> samples, double passed) {
  for (std::size_t k = 1; k < samples.size(); ++k) {
    const PassedAt &before = samples[k - 1], &after = samples[k];
    if (before.passed < passed && after.passed >= passed)
      return std::lerp(before.time, after.time, (passed - before.passed) / (after.passed - before.passed));
  }
  throw_input_error("flow rate", fmt::format("{} grains never passed", passed));
}

}  // namespace

double flow_rate(std::span<const PassedAt> samples, double from, double to) {
  return (to - from) / (time_of(samples, to) - time_of(samples, from));
}

double repose_angle(std::span<const Vector3d> positions, double radius, double floor) {
  const double width = 2 * radius;
  std::vector<double> top;
  for (const Vector3d& x : positions) {
    const auto bin = static_cast<std::size_t>(std::abs(x.x()) / width);
    if (bin >= top.size()) top.resize(bin + 1, 0);
    top[bin] = std::max(top[bin], x.z() + radius - floor);
  }
  double n = 0, sum_x = 0, sum_z = 0, sum_xx = 0, sum_xz = 0;
  for (std::size_t bin = 1; bin < top.size() && top[bin] > 1.2 * width; ++bin) {
    const double x = (static_cast<double>(bin) + 0.5) * width;
    n += 1;
    sum_x += x;
    sum_z += top[bin];
    sum_xx += x * x;
    sum_xz += x * top[bin];
  }
  if (n < 2) throw_input_error("repose angle", "no slope", "a heap of two layers or more");
  const double slope = (n * sum_xz - sum_x * sum_z) / (n * sum_xx - sum_x * sum_x);
  return std::atan(-slope) * 180 / std::numbers::pi;
}

double packing_fraction(std::span<const Vector3d> positions, double radius, const Vector3d& lower,
                        const Vector3d& upper) {
  const auto inside = std::ranges::count_if(positions, [&](const Vector3d& x) {
    return (x.array() >= lower.array()).all() && (x.array() <= upper.array()).all();
  });
  return static_cast<double>(inside) * 4.0 / 3 * std::numbers::pi * std::pow(radius, 3) /
         (upper - lower).prod();
}

}  // namespace warpgrain
