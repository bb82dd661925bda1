#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <set>

#include "core/collision_grid.hpp"
#include "core/error.hpp"

namespace warpgrain {
namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

template <class Real>
std::vector<Vector3<Real>> random_points(const Box& box, std::size_t n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vector3<Real>> points;
  for (std::size_t k = 0; k < n; ++k) {
    const Vector3d u(unit(random), unit(random), unit(random));
    points.push_back((box.lower + u.cwiseProduct(box.upper - box.lower)).cast<Real>());
  }
  return points;
}

template <class Real>
Pairs pairs_from_grid(const CollisionGrid& grid, const std::vector<Vector3<Real>>& points, Real reach) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    grid.for_each_near(cell_coordinates(grid.geometry(), points[i]), [&](std::uint32_t j) {
      if (i < j && (points[j] - points[i]).norm() < reach) pairs.emplace(i, j);
    });
  return pairs;
}

template <class Real>
Pairs pairs_by_brute_force(const std::vector<Vector3<Real>>& points, Real reach) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    for (std::uint32_t j = i + 1; j < points.size(); ++j)
      if ((points[j] - points[i]).norm() < reach) pairs.emplace(i, j);
  return pairs;
}

template <class Real>
class CollisionGridOf : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(CollisionGridOf, Reals);

TYPED_TEST(CollisionGridOf, FindsThePairsThatBruteForceFinds) {
  const Box boxes[] = {{{0, 0, 0}, {1, 1, 1}}, {{-3, 2, -0.1}, {-2.5, 4, 0.1}}, {{0, 0, 0}, {5, 0.01, 0.01}}};
  for (const Box& box : boxes)
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const auto points = random_points<TypeParam>(box, 300, seed);
      const TypeParam reach = static_cast<TypeParam>(0.13);
      CollisionGrid grid(make_grid_geometry(box, reach, points.size()));
      grid.build<TypeParam>(points);
      EXPECT_EQ(pairs_from_grid(grid, points, reach), pairs_by_brute_force(points, reach)) << "seed " << seed;
    }
}

TYPED_TEST(CollisionGridOf, MapsAgreeWithEachOther) {
  const Box box{{0, 0, 0}, {1, 2, 3}};
  const auto points = random_points<TypeParam>(box, 500, 7);
  CollisionGrid grid(make_grid_geometry(box, 0.3, points.size()));
  grid.build<TypeParam>(points);

  const auto map = grid.correspondence_map();
  std::vector<CellEntry> expected(map.begin(), map.end());
  for (std::uint32_t p = 0; p < expected.size(); ++p) EXPECT_EQ(expected[p].particle, p);
  std::stable_sort(expected.begin(), expected.end(),
                   [](const CellEntry& a, const CellEntry& b) { return a.cell < b.cell; });
  const auto sorted = grid.sorted_correspondence_map();
  EXPECT_TRUE(std::equal(sorted.begin(), sorted.end(), expected.begin(), expected.end()));
  std::size_t listed = 0;
  for (std::uint32_t cell = 0; cell < grid.geometry().cell_count(); ++cell) {
    EXPECT_EQ(grid.cell_start(cell), listed);
    for (const CellEntry& entry : grid.cell_entries(cell)) EXPECT_EQ(entry.cell, cell);
    listed += grid.cell_entries(cell).size();
    EXPECT_EQ(grid.cell_end(cell), listed);
  }
  EXPECT_EQ(listed, points.size());
}

TEST(CollisionGrid, NumbersCellsWithXFastest) {
  const GridGeometry grid = make_grid_geometry({{-1, 0, 0}, {1, 3, 4}}, 1, 10);
  EXPECT_EQ(grid.n_cells, (std::array<std::uint32_t, 3>{2, 3, 4}));
  EXPECT_EQ(cell_coordinates(grid, Vector3d(0.5, 1.5, 2.5)), (std::array<std::uint32_t, 3>{1, 1, 2}));
  EXPECT_EQ(cell_index(grid, {1, 1, 2}), 1u + 2u * (1u + 3u * 2u));
}

TEST(CollisionGrid, PutsTheUpperBoundaryIntoTheLastCell) {
  const GridGeometry grid = make_grid_geometry({{0, 0, 0}, {1, 1, 1}}, 0.25, 10);
  EXPECT_EQ(cell_coordinates(grid, Vector3d(1, 1, 1)), (std::array<std::uint32_t, 3>{3, 3, 3}));
}

TEST(CollisionGrid, WidensItsCellsRatherThanFillingTheMemory) {
  const GridGeometry grid = make_grid_geometry({{0, 0, 0}, {1000, 1000, 1000}}, 1e-3, 2);
  EXPECT_LE(grid.cell_count(), std::size_t{1} << 21);
  EXPECT_GE(grid.cell_edge * grid.n_cells[0], 1000);
}

TEST(CollisionGrid, RefusesWhatIsNoBox) {
  EXPECT_THROW(make_grid_geometry({{0, 0, 0}, {1, 0, 1}}, 1, 2), InputError);
  EXPECT_THROW(make_grid_geometry({{0, 0, 0}, {1, 1, std::nan("")}}, 1, 2), InputError);
  EXPECT_THROW(make_grid_geometry({{0, 0, 0}, {1, 1, 1}}, 0, 2), InputError);
}

}  // namespace
}  // namespace warpgrain
