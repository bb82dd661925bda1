#include "core/collision_grid.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain {

GridGeometry make_grid_geometry(const Box& domain, double cell_edge, std::size_t n_particles) {
  const Vector3d size = domain.upper - domain.lower;
  if (!(cell_edge > 0) || !std::isfinite(cell_edge))
    throw_input_error("collision grid", fmt::format("cell edge {}", cell_edge), "a positive length");
  if (!size.allFinite() || !(size.minCoeff() > 0))
    throw_input_error("collision grid",
                      fmt::format("domain of size {} x {} x {}", size.x(), size.y(), size.z()),
                      "a box with a volume");
  const double limit = std::max<double>(1u << 21, 16.0 * static_cast<double>(n_particles));
  // Whole cells only, so that every cell is at least cell_edge wide and the last one ends beyond the domain.
  const auto cells = [&] { return (size / cell_edge).array().ceil().cwiseMax(1.0).eval(); };
  while (cells().prod() > limit) cell_edge *= 2;
  GridGeometry grid;
  grid.cell_edge = cell_edge;
  for (int d = 0; d < 3; ++d) {
    grid.lower[d] = domain.lower[d];
    grid.n_cells[d] = static_cast<std::uint32_t>(cells()[d]);
  }
  return grid;
}

GridGeometry make_grid_geometry(const Scene& scene) {
  const auto& radius = scene.particles.radius;
  if (radius.empty()) throw_input_error("collision grid", "no particles", "at least one");
  return make_grid_geometry(scene.domain, 2 * *std::max_element(radius.begin(), radius.end()), radius.size());
}

template <class Real>
std::array<std::uint32_t, 3> cell_coordinates(const GridGeometry& grid, const Vector3<Real>& position) {
  std::array<std::uint32_t, 3> c;
  for (int d = 0; d < 3; ++d) {
    const Real along = (position[d] - static_cast<Real>(grid.lower[d])) / static_cast<Real>(grid.cell_edge);
    // In float a position inside may round to just below the lower corner.
    c[d] = std::min(static_cast<std::uint32_t>(std::max(along, Real(0))), grid.n_cells[d] - 1);
  }
  return c;
}

CollisionGrid::CollisionGrid(const GridGeometry& geometry)
    : geometry_(geometry), cell_start_(geometry.cell_count() + 1, 0) {}

template <class Real>
void CollisionGrid::build(std::span<const Vector3<Real>> positions) {
  map_.resize(positions.size());
  sorted_map_.resize(positions.size());
  std::fill(cell_start_.begin(), cell_start_.end(), 0u);
  for (std::uint32_t p = 0; p < positions.size(); ++p) {
    map_[p] = {cell_index(geometry_, cell_coordinates(geometry_, positions[p])), p};
    ++cell_start_[map_[p].cell];
  }
  // A counting sort, stable, so that the particles of a cell stay in ascending order: turn the counts into
  // ends, then fill each cell from its end downwards; its end counter arrives at its start.
  std::uint32_t total = 0;
  for (std::uint32_t& start : cell_start_) start = total += start;
  for (auto entry = map_.rbegin(); entry != map_.rend(); ++entry)
    sorted_map_[--cell_start_[entry->cell]] = *entry;
}

template std::array<std::uint32_t, 3> cell_coordinates<float>(const GridGeometry&, const Vector3<float>&);
template std::array<std::uint32_t, 3> cell_coordinates<double>(const GridGeometry&, const Vector3<double>&);
template void CollisionGrid::build<float>(std::span<const Vector3<float>>);
template void CollisionGrid::build<double>(std::span<const Vector3<double>>);

}  // namespace warpgrain
