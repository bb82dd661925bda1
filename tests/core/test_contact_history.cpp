#include <gtest/gtest.h>

#include "core/contact_history.hpp"

namespace warpgrain {
namespace {

TEST(ContactHistory, TheSmallerIdDecidesForThePair) {
  const std::uint32_t wall = wall_partner_bit | 3;
  ContactHistory history{{2, 5, Vector3d(1, 2, 3)},
                         {2, 9, Vector3d(7, 7, 7)},  // the other side has ended
                         {2, wall, Vector3d(4, 4, 4)},
                         {5, 2, Vector3d(-1.1, -2, -3)}};
  make_antisymmetric(history);
  EXPECT_EQ(history[0].tangential_displacement, Vector3d(1, 2, 3));
  EXPECT_EQ(history[1].tangential_displacement, Vector3d(7, 7, 7));
  EXPECT_EQ(history[2].tangential_displacement, Vector3d(4, 4, 4));
  EXPECT_EQ(history[3].tangential_displacement, Vector3d(-1, -2, -3));
}

}  // namespace
}  // namespace warpgrain
