#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>

#include "cli/bed.hpp"
#include "core/candidate_census.hpp"

namespace warpgrain::cli {
namespace {

struct Drawn {
  Scene scene;
  ProfiledState left;
  std::vector<profiler::LaunchProfile> launches;
  std::optional<reports::Bed> bed;
};

Drawn drawn(const char* search, std::uint64_t most) {
  Drawn result;
  result.scene = load_scene("settled_bed", {300, 7});
  Variant variant;
  variant.set("search", search);
  profiler::ProfileOptions how;
  how.addresses = false;
  how.checks = profiler::Checks::off;
  result.launches = profile_step(result.scene, variant, how, {}, {}, &result.left);
  result.bed = bed_of(result.scene, variant, result.launches, result.left, most);
  return result;
}

TEST(Bed, HoldsEveryParticleWithItsNeighboursAndWarp) {
  const Drawn all = drawn("cells", 1000);
  ASSERT_TRUE(all.bed);
  const reports::Bed& bed = *all.bed;
  EXPECT_EQ(bed.particles, 300U);
  EXPECT_TRUE(bed.slab.empty());
  ASSERT_EQ(bed.x.size(), 300U);
  EXPECT_EQ(bed.radius.size(), 1U);
  EXPECT_EQ(bed.kernel, "force_between_particles");
  EXPECT_TRUE(std::ranges::is_sorted(bed.warp));  // in the order of the work-items
  EXPECT_EQ(bed.warp.back(), 299U / 32);
  Scene now = all.scene;
  now.particles = all.left.particles;
  const CandidateCensus census = candidate_census(now);
  EXPECT_DOUBLE_EQ(
      static_cast<double>(std::accumulate(bed.contacts.begin(), bed.contacts.end(), std::uint64_t{0})) / 300,
      census.mean_contacts);
  EXPECT_EQ(*std::ranges::max_element(bed.candidates), census.most_candidates);
  // A particle stands where the state has it.
  for (const std::size_t k : {0U, 123U, 299U}) {
    const auto at = std::ranges::find(all.left.places, k) - all.left.places.begin();
    const Vector3d& position = all.left.particles.position[static_cast<std::size_t>(at)];
    EXPECT_NEAR(static_cast<double>(bed.x[k]) * bed.unit, position[0], bed.unit);
    EXPECT_NEAR(static_cast<double>(bed.z[k]) * bed.unit, position[2], bed.unit);
  }
  for (const double efficiency : bed.efficiency) {
    EXPECT_GT(efficiency, 0);
    EXPECT_LE(efficiency, 1);
  }
}

TEST(Bed, OfManyParticlesIsASlab) {
  const Drawn some = drawn("cells", 100);
  ASSERT_TRUE(some.bed);
  EXPECT_EQ(some.bed->x.size(), 100U);
  EXPECT_EQ(some.bed->particles, 300U);
  EXPECT_THAT(some.bed->slab, testing::StartsWith("the 100 nearest to "));
  EXPECT_FALSE(bed_of(some.scene, Variant(), some.launches, some.left, 0));
}

TEST(Bed, HasNoWarpsWhereWorkItemsAreOfNoParticle) {
  const Drawn cells = drawn("warp_per_cell", 1000);
  ASSERT_TRUE(cells.bed);
  EXPECT_TRUE(cells.bed->kernel.empty());
  EXPECT_TRUE(cells.bed->warp.empty());
  EXPECT_EQ(cells.bed->x.size(), 300U);
}

}  // namespace
}  // namespace warpgrain::cli
