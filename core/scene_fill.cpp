#include "core/scene_fill.hpp"

#include <cmath>
#include <fmt/format.h>
#include <random>
#include <utility>

#include "core/error.hpp"

namespace warpgrain {
namespace {

using Counts = Eigen::Array<double, 3, 1>;

// How many lattice cells of at least `edge` fit along each side; whole numbers, in double against overflow.
Counts cells_along(const Vector3d& size, double edge) { return (size.array() / edge).floor(); }

// The standard library's distributions differ between implementations; this one does not.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

// Cells of exactly the diameter would leave spheres touching by rounding.
double least_edge_of(const FillSpec& fill) { return 2 * fill.radius * (1 + 1e-9); }

// The most spheres that the box holds.
double room_of(const FillSpec& fill) {
  return cells_along(fill.box.upper - fill.box.lower, least_edge_of(fill)).prod();
}

}  // namespace

bool fits(const FillSpec& fill) { return room_of(fill) >= static_cast<double>(fill.count); }

std::vector<Vector3d> fill_positions(const FillSpec& fill, std::string_view where) {
  const double diameter = 2 * fill.radius, least_edge = least_edge_of(fill);
  const Vector3d size = fill.box.upper - fill.box.lower;
  const double count = static_cast<double>(fill.count);
  if (!fits(fill))
    throw_input_error(where,
                      fmt::format("{} spheres of radius {} do not fit a box of {} x {} x {}", fill.count,
                                  fill.radius, size.x(), size.y(), size.z()),
                      fmt::format("at most {}", room_of(fill)));
  double edge = std::cbrt(size.prod() / count);
  while (edge > least_edge && cells_along(size, edge).prod() < count) edge *= 0.999;
  const Counts n = cells_along(size, std::max(edge, least_edge));
  const Vector3d cell = size.array() / n;
  // Nearly all of the free room; the rest keeps neighbours apart whatever rounding does.
  const Vector3d jitter = 0.9 * (cell.array() - diameter);

  std::mt19937_64 random(fill.seed);
  std::vector<Vector3d> positions;
  positions.reserve(fill.count);
  for (std::uint64_t k = 0; k < fill.count; ++k) {
    const auto nx = static_cast<std::uint64_t>(n.x()), ny = static_cast<std::uint64_t>(n.y());
    const Vector3d place(static_cast<double>(k % nx), static_cast<double>(k / nx % ny),
                         static_cast<double>(k / (nx * ny)));
    Vector3d position;
    for (int d = 0; d < 3; ++d)
      position[d] = fill.box.lower[d] + cell[d] * (place[d] + 0.5) + jitter[d] * (uniform(random) - 0.5);
    positions.push_back(position);
  }
  // Grains that are poured come in no order: neighbours in space are not neighbours in the arrays. (Fisher
  // and Yates; std::shuffle, too, differs between implementations.)
  for (std::size_t k = positions.size(); k > 1; --k)
    std::swap(positions[k - 1],
              positions[static_cast<std::size_t>(uniform(random) * static_cast<double>(k))]);
  return positions;
}

}  // namespace warpgrain
