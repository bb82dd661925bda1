#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/candidate_census.hpp"
#include "core/collision_grid.hpp"

namespace warpgrain {
namespace {

// Against all pairs, cell coordinates apart by at most one.
TEST(CandidateCensus, CountsWhatAllPairsGive) {
  const Scene scene = load_scene("settled_bed", {300, 7});
  const ParticleState& particles = scene.particles;
  const GridGeometry grid = make_grid_geometry(scene);
  std::uint64_t candidates = 0, contacts = 0;
  std::uint32_t most_candidates = 0, most_contacts = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    std::uint32_t near = 0, touching = 0;
    const auto a = cell_coordinates(grid, particles.position[i]);
    for (std::size_t j = 0; j < particles.size(); ++j) {
      const auto b = cell_coordinates(grid, particles.position[j]);
      bool in_27 = i != j;
      for (std::size_t d = 0; d < 3; ++d) in_27 = in_27 && std::abs(int(a[d]) - int(b[d])) <= 1;
      if (!in_27) continue;
      ++near;
      if ((particles.position[i] - particles.position[j]).norm() < particles.radius[i] + particles.radius[j])
        ++touching;
    }
    candidates += near;
    contacts += touching;
    most_candidates = std::max(most_candidates, near);
    most_contacts = std::max(most_contacts, touching);
  }
  const CandidateCensus census = candidate_census(scene);
  EXPECT_DOUBLE_EQ(census.mean_candidates, static_cast<double>(candidates) / 300);
  EXPECT_DOUBLE_EQ(census.mean_contacts, static_cast<double>(contacts) / 300);
  EXPECT_EQ(census.most_candidates, most_candidates);
  EXPECT_EQ(census.most_contacts, most_contacts);
  EXPECT_GT(census.mean_candidates, 0);
}

TEST(CandidateCensus, OfNothingIsZero) {
  Scene scene = load_scene("settled_bed", {300, 7});
  scene.particles = {};
  EXPECT_EQ(candidate_census(scene).mean_candidates, 0);
}

}  // namespace
}  // namespace warpgrain
