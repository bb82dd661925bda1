#include <gtest/gtest.h>

#include "core/collision_grid.hpp"
#include "core/error.hpp"
#include "core/scene_fill.hpp"

namespace warpgrain {
namespace {

TEST(SceneFill, SpheresLieInTheBoxWithoutTouching) {
  for (std::uint64_t count : {1u, 10u, 1000u, 2700u}) {
    const FillSpec fill{{{1, 0, -1}, {1.1, 0.1, -0.87}}, count, 0.0035, count};
    const auto positions = fill_positions(fill, "fill");
    ASSERT_EQ(positions.size(), count);
    for (const Vector3d& p : positions) {
      EXPECT_TRUE(((p - fill.box.lower).array() >= fill.radius).all()) << p;
      EXPECT_TRUE(((fill.box.upper - p).array() >= fill.radius).all()) << p;
    }
    CollisionGrid grid(make_grid_geometry(fill.box, 2 * fill.radius, count));
    grid.build<double>(positions);
    for (std::uint32_t i = 0; i < count; ++i)
      grid.for_each_near(cell_coordinates(grid.geometry(), positions[i]), [&](std::uint32_t j) {
        if (i < j) {
          EXPECT_GT((positions[i] - positions[j]).norm(), 2 * fill.radius);
        }
      });
  }
}

TEST(SceneFill, FitsExactlyWhatTheLatticeHolds) {
  FillSpec fill{{{0, 0, 0}, {0.1, 0.1, 0.1}}, 9 * 9 * 9, 0.0055};
  EXPECT_TRUE(fits(fill));
  EXPECT_EQ(fill_positions(fill, "fill").size(), 729u);
  ++fill.count;
  EXPECT_FALSE(fits(fill));
  EXPECT_THROW(fill_positions(fill, "fill"), InputError);
}

}  // namespace
}  // namespace warpgrain
