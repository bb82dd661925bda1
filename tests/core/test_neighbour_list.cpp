#include <gtest/gtest.h>
#include <random>

#include "core/contact_history.hpp"
#include "core/neighbour_list.hpp"

namespace warpgrain {
namespace {

TEST(NeighbourList, ListsWhatIsWithinTheSkinOnceAndInOrder) {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Vector3d> positions;
  std::vector<double> radius;
  for (int k = 0; k < 400; ++k) {
    positions.emplace_back(unit(random), unit(random), unit(random));
    radius.push_back(0.02 + 0.03 * unit(random));
  }
  std::vector<Wall> walls(2);
  walls[1].point = Vector3d::Ones();
  walls[1].normal = -Vector3d::UnitX();
  const double skin = 0.015;
  NeighbourList<double> list(box, walls, radius, skin, {{0, 130}, {130, 400}});
  list.build(positions);

  for (std::size_t range = 0; range < 2; ++range)
    for (std::size_t i = list.ranges()[range].first; i < list.ranges()[range].last; ++i) {
      std::vector<std::uint32_t> expected;
      for (std::uint32_t j = static_cast<std::uint32_t>(i) + 1; j < positions.size(); ++j)
        if ((positions[i] - positions[j]).norm() < radius[i] + radius[j] + skin) expected.push_back(j);
      if (positions[i].z() < radius[i] + skin) expected.push_back(wall_partner_bit);
      if (1 - positions[i].x() < radius[i] + skin) expected.push_back(wall_partner_bit | 1);
      const PartnerRows& rows = list.rows(range);
      const std::size_t row = i - list.ranges()[range].first;
      EXPECT_EQ(std::vector(rows.partner.begin() + rows.row_start[row],
                            rows.partner.begin() + rows.row_start[row + 1]),
                expected)
          << "of particle " << i;
    }
}

TEST(NeighbourList, IsOutdatedBeforeTwoParticlesCanCrossTheSkin) {
  NeighbourList<float> list({{0, 0, 0}, {1, 1, 1}}, {}, {0.1f}, 0.02, {{0, 1}});
  EXPECT_FALSE(list.outdated_by(0.0097f * 0.0097f));
  EXPECT_TRUE(list.outdated_by(0.01f * 0.01f));
  EXPECT_TRUE(list.outdated_by(std::nanf("")));
}

}  // namespace
}  // namespace warpgrain
