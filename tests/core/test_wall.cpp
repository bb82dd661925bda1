#include <cmath>
#include <gtest/gtest.h>

#include "core/wall.hpp"

namespace warpgrain {
namespace {

Wall unit_square() {
  Wall wall;
  wall.kind = WallKind::rectangle;
  wall.edge_u = Vector3d::UnitX();
  wall.edge_v = Vector3d::UnitY();
  return wall;
}

void expect_near(const WallProximity& near, double distance, const Vector3d& normal) {
  EXPECT_NEAR(near.distance, distance, 1e-15);
  EXPECT_NEAR((near.contact_normal - normal).norm(), 0, 1e-15);
}

TEST(Wall, PlaneIsOneSided) {
  Wall plane;
  plane.point = {0, 0, 1};
  expect_near(wall_proximity(plane, Vector3d(5, -3, 1.5)), 0.5, -Vector3d::UnitZ());
  expect_near(wall_proximity(plane, Vector3d(5, -3, 0.75)), -0.25, -Vector3d::UnitZ());
}

TEST(Wall, RectangleIsTwoSided) {
  expect_near(wall_proximity(unit_square(), Vector3d(0.5, 0.5, 0.25)), 0.25, -Vector3d::UnitZ());
  expect_near(wall_proximity(unit_square(), Vector3d(0.5, 0.5, -0.25)), 0.25, Vector3d::UnitZ());
}

TEST(Wall, RectangleIsTouchedAtItsEdgesAndCorners) {
  expect_near(wall_proximity(unit_square(), Vector3d(1.3, 0.5, 0.4)), 0.5, Vector3d(-0.6, 0, -0.8));
  expect_near(wall_proximity(unit_square(), Vector3d(0.5, -0.3, 0.4)), 0.5, Vector3d(0, 0.6, -0.8));
  const Vector3d beyond(2, 3, 2);  // the corner at (1, 1, 0) is 3 away
  expect_near(wall_proximity(unit_square(), beyond), 3, Vector3d(-1, -2, -2) / 3);
}

TEST(Wall, CentreOnARectangleHasADirection) {
  expect_near(wall_proximity(unit_square(), Vector3d(0.5, 0.5, 0)), 0, -Vector3d::UnitZ());
}

}  // namespace
}  // namespace warpgrain
