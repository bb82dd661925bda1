#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "analysis/heap.hpp"
#include "core/error.hpp"

namespace warpgrain {
namespace {

TEST(Heap, FlowRateIsThatBetweenTwoCounts) {
  const std::array samples{PassedAt{0, 0}, PassedAt{1, 0}, PassedAt{2, 10}, PassedAt{3, 30}};
  EXPECT_DOUBLE_EQ(flow_rate(samples, 5, 20), 15 / (2.5 - 1.5));
  EXPECT_THROW(flow_rate(samples, 5, 31), InputError);
}

// A wedge of grains whose tops fall by tan(25 degrees).
TEST(Heap, ReposeAngleIsTheSlopesWhateverTheFloor) {
  const double slope = std::tan(25 * M_PI / 180), radius = 0.01, floor = -3;
  std::vector<Vector3d> positions;
  for (int side : {-1, 1})
    for (int k = 0; k < 20; ++k) {
      const double x = (k + 0.5) * 2 * radius;
      positions.push_back({side * x, 0, floor - radius + 0.25 - slope * x});
    }
  EXPECT_NEAR(repose_angle(positions, radius, floor), 25, 1e-6);
  const std::array flat{Vector3d(0, 0, floor + radius), Vector3d(0.1, 0, floor + radius)};
  EXPECT_THROW(repose_angle(flat, radius, floor), InputError);
}

TEST(Heap, PackingFractionCountsCentres) {
  const std::array positions{Vector3d(0, 0, 0), Vector3d(0.5, 0, 0), Vector3d(5, 0, 0)};
  EXPECT_DOUBLE_EQ(packing_fraction(positions, 0.5, Vector3d::Constant(-1), Vector3d::Constant(1)),
                   2 * 4.0 / 3 * M_PI / 8 / 8);
}

}  // namespace
}  // namespace warpgrain
