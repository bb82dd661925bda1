#include "variants/fixed_point.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <span>

#include "core/error.hpp"
#include "kernels/layout.h"

namespace warpgrain {
namespace {

constexpr int bits_of_places = 61, bits_of_double = 53, bits_of_float = 24, bits_of_axes = 62;
// Kernels look at pairs that are up to six cells apart: coarse parts of less than 2^30 and rests of 31 bits.
constexpr int bits_of_cell = 27, bits_of_rest = 31;

int exponent_above(double length) { return static_cast<int>(std::ceil(std::log2(length))); }

double farthest_coordinate(const Scene& scene) {
  double farthest = 0;
  const auto include = [&](const Vector3d& place) {
    farthest = std::max(farthest, place.cwiseAbs().maxCoeff());
  };
  include(scene.domain.lower);
  include(scene.domain.upper);
  for (const Wall& wall : scene.walls) {
    include(wall.point);
    include(wall.point + wall.edge_u + wall.edge_v);
  }
  return farthest;
}

layout::Triple<float> rounded_triple(const Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

template <class T>
std::vector<std::byte> bytes_of_rows(const std::vector<T>& rows) {
  const auto bytes = std::as_bytes(std::span(rows));
  return {bytes.begin(), bytes.end()};
}

}  // namespace

std::int64_t FixedPoint::units(double length) const {
  if (std::isnan(length)) return std::numeric_limits<std::int64_t>::min();
  const double bound = std::exp2(62);
  return std::llrint(std::clamp(std::ldexp(length, -unit_exponent), -bound, bound));
}

double FixedPoint::length(std::int64_t units) const {
  return std::ldexp(static_cast<double>(units), unit_exponent);
}

std::string FixedPoint::build_options() const {
  return fmt::format("-D FIXED_POINT -D POSITION_UNIT=0x1p{}f -D SEPARATION_SHIFT={}", unit_exponent,
                     coarse_shift);
}

FixedPoint fixed_point_for(const Scene& scene, double cell_edge) {
  const double farthest = farthest_coordinate(scene), radius = std::ranges::min(scene.particles.radius);
  const double most = std::ldexp(radius, bits_of_double - bits_of_float - 1);
  if (farthest > most)
    throw_input_error("scene", fmt::format("{} m from the origin with a radius of {} m", farthest, radius),
                      fmt::format("at most {} m: states in double are no finer than floats there", most));
  const int coarse_exponent = exponent_above(cell_edge) - bits_of_cell;
  FixedPoint fixed_point;
  fixed_point.unit_exponent =
      std::max(exponent_above(farthest) - bits_of_places, coarse_exponent - bits_of_rest);
  fixed_point.coarse_shift = std::max(coarse_exponent - fixed_point.unit_exponent, 0);
  return fixed_point;
}

std::vector<std::byte> fixed_places(const ParticleState& particles, const FixedPoint& fixed_point) {
  std::vector<std::int64_t> places;
  places.reserve(4 * particles.size());
  for (std::size_t k = 0; k < particles.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) places.push_back(fixed_point.units(particles.position[k][axis]));
    places.push_back(fixed_point.units(particles.radius[k]));
  }
  return bytes_of_rows(places);
}

std::vector<std::byte> fixed_wall_rows(const std::vector<Wall>& walls, const FixedPoint& fixed_point) {
  std::vector<layout::FixedWallLayout<float>> rows;
  for (const Wall& wall : walls) {
    layout::FixedWallLayout<float> row{};
    const bool is_rectangle = wall.kind == WallKind::rectangle;
    const Vector3d none = Vector3d::Zero();
    const Vector3d along_u = is_rectangle ? wall.edge_u.normalized() : none,
                   along_v = is_rectangle ? wall.edge_v.normalized() : none;
    const Vector3d* axes[] = {&wall.normal, &along_u, &along_v};
    for (int k = 0; k < 3; ++k) {
      row.point[k] = fixed_point.units(wall.point[k]);
      for (int axis = 0; axis < 3; ++axis)
        row.axes[axis][k] = std::llrint(std::ldexp((*axes[axis])[k], bits_of_axes));
    }
    row.length_u = fixed_point.units(wall.edge_u.norm());
    row.length_v = fixed_point.units(wall.edge_v.norm());
    row.normal = rounded_triple(wall.normal);
    row.along_u = rounded_triple(along_u);
    row.along_v = rounded_triple(along_v);
    row.is_rectangle = is_rectangle ? 1 : 0;
    row.material = wall.material;
    rows.push_back(row);
  }
  if (rows.empty()) rows.emplace_back();  // a buffer of no bytes cannot be made
  return bytes_of_rows(rows);
}

}  // namespace warpgrain
