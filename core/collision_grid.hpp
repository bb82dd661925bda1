#pragma once
// The collision grid: a uniform grid of cubic cells in which contact partners are looked for, and the three
// maps the paper builds on it. CM, the correspondence map, lists (cell, particle); SCM is the same sorted by
// cell; SCCM gives for each cell where its entries start and end in the SCM. Partners of a particle whose
// distance is at most one cell edge lie in the 27 cells around its own.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/scene.hpp"
#include "core/vector3.hpp"

namespace warpgrain {

// Plain numbers, so that a back end can hand them to its kernels as they are.
struct GridGeometry {
  std::array<double, 3> lower{};           // m
  double cell_edge = 0;                    // m
  std::array<std::uint32_t, 3> n_cells{};  // each at least 1

  std::size_t cell_count() const { return std::size_t{n_cells[0]} * n_cells[1] * n_cells[2]; }
};

// The grid over `domain` whose cells are at least `cell_edge` [m] wide. The edge grows by powers of two where
// the cells would outnumber both 2^21 and 16 cells a particle. Throws InputError when the domain or the edge
// is not usable.
GridGeometry make_grid_geometry(const Box& domain, double cell_edge, std::size_t n_particles);
// The same for a scene: its domain, and the largest particle diameter as the edge.
GridGeometry make_grid_geometry(const Scene& scene);

// Eq. (11): the cell coordinates of a position; a position on the upper boundary belongs to the last cell.
// The position must lie in the grid.
template <class Real>
std::array<std::uint32_t, 3> cell_coordinates(const GridGeometry& grid, const Vector3<Real>& position);
// Eq. (12): the linear index of a cell, x fastest.
inline std::uint32_t cell_index(const GridGeometry& grid, const std::array<std::uint32_t, 3>& c) {
  return c[0] + grid.n_cells[0] * (c[1] + grid.n_cells[1] * c[2]);
}

struct CellEntry {
  std::uint32_t cell = 0;
  std::uint32_t particle = 0;  // index, not id
  bool operator==(const CellEntry&) const = default;
};

class CollisionGrid {
 public:
  explicit CollisionGrid(const GridGeometry& geometry);

  // Builds the three maps for these positions [n_particles], all inside the grid.
  template <class Real>
  void build(std::span<const Vector3<Real>> positions);

  const GridGeometry& geometry() const { return geometry_; }
  std::span<const CellEntry> correspondence_map() const { return map_; }                // CM [n_particles]
  std::span<const CellEntry> sorted_correspondence_map() const { return sorted_map_; }  // SCM [n_particles]
  // The entries of SCM that lie in a cell (SCCM), in ascending order of particle.
  std::span<const CellEntry> cell_entries(std::uint32_t cell) const {
    return std::span(sorted_map_).subspan(cell_start_[cell], cell_end(cell) - cell_start_[cell]);
  }
  std::uint32_t cell_start(std::uint32_t cell) const { return cell_start_[cell]; }
  std::uint32_t cell_end(std::uint32_t cell) const { return cell_start_[cell + 1]; }

  // Calls visit(particle) for every particle in the 27 cells around `cell`, cell by cell in ascending index.
  // Cells that follow one another along x follow one another in the SCM too, so nine runs are read.
  template <class Visit>
  void for_each_near(const std::array<std::uint32_t, 3>& cell, Visit&& visit) const {
    const auto& n = geometry_.n_cells;
    const std::uint32_t x0 = cell[0] ? cell[0] - 1 : 0, x1 = cell[0] + 1 < n[0] ? cell[0] + 1 : cell[0];
    for (std::uint32_t z = cell[2] ? cell[2] - 1 : 0; z <= cell[2] + 1 && z < n[2]; ++z)
      for (std::uint32_t y = cell[1] ? cell[1] - 1 : 0; y <= cell[1] + 1 && y < n[1]; ++y) {
        const std::uint32_t end = cell_end(cell_index(geometry_, {x1, y, z}));
        for (std::uint32_t k = cell_start(cell_index(geometry_, {x0, y, z})); k < end; ++k)
          visit(sorted_map_[k].particle);
      }
  }

 private:
  GridGeometry geometry_;
  std::vector<CellEntry> map_, sorted_map_;
  std::vector<std::uint32_t> cell_start_;  // [cell_count + 1]; a cell ends where the next one starts
};

}  // namespace warpgrain
