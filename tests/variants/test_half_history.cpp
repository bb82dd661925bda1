// Precision `fp16_history`: what halves hold of tangential displacements, and what is said where they do not.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "random_bed.hpp"
#include "variants/backend.hpp"
#include "variants/combinations.hpp"
#include "variants/device_scene.hpp"
#include "variants/half_history.hpp"

namespace warpgrain {
namespace {

using testing::HasSubstr;

const char* const half_variant = "branchy/cells/cell/fp16_history/default";

std::vector<double> round_trip(const HalfHistory& history, const std::vector<Vector3d>& vectors) {
  const std::vector<std::byte> stored = history.stored(vectors);
  std::vector<std::uint16_t> halves(3 * vectors.size());
  std::memcpy(halves.data(), stored.data(), stored.size());
  return history.lengths(halves);
}

TEST(HalfHistory, HoldsElevenBitsOfDisplacementsOfAllSizesThatOccur) {
  const double radius = 0.0047;
  const HalfHistory history(radius);
  for (double size = 4e-9 * radius; size < 2 * radius; size *= 1.7) {
    ASSERT_TRUE(history.can_store({size, 0, -size}));
    const auto lengths = round_trip(history, {{size, 0, -size}});
    EXPECT_NEAR(lengths[0] / size, 1, std::exp2(-11)) << size;
    EXPECT_EQ(lengths[2], -lengths[0]);
    EXPECT_EQ(lengths[1], 0);
  }
  EXPECT_FALSE(history.can_store({0, 4.1 * radius, 0}));
}

TEST(HalfHistory, TakesHalfTheBytes) {
  const Scene bed = random_bed({.n_particles = 50});
  const auto bytes_in = [&](const char* variant) {
    return lay_out(bed, Variant::parse(variant)).bytes[DeviceArray::history_displacements];
  };
  EXPECT_EQ(2 * bytes_in(half_variant), bytes_in("branchy/cells/cell/fp32/default"));
}

// Halves are what the state holds: another device goes on from them bit by bit.
TEST(HalfHistory, ContinuesFromAState) {
  Scene bed = random_bed({.n_particles = 500, .seed = 6});
  const auto create = [](const Scene& scene) {
    return backend("opencl").create(scene, Variant::parse(half_variant), {});
  };
  bed.particles = create(bed)->state();  // in the order of ids, so that sums are in one order
  const auto whole = create(bed);
  whole->step(9);
  Scene half = bed;
  half.particles = whole->state();
  const auto continued = create(half);
  whole->step(9);
  continued->step(9);
  EXPECT_EQ(whole->state().velocity, continued->state().velocity);
  EXPECT_EQ(whole->forces().torque, continued->forces().torque);
}

std::string message_of_half(const Scene& scene, std::uint64_t steps) {
  try {
    backend("opencl").create(scene, Variant::parse(half_variant), {})->step(steps);
  } catch (const SimulationError& e) {
    return e.what();
  }
  return "no error";
}

TEST(HalfHistory, ADisplacementBeyondHalvesIsSaid) {
  Scene bed = random_bed({.n_particles = 2, .history = false});
  const double radius = std::ranges::min(bed.particles.radius);
  bed.particles.contact_history = {{100, 101, {9 * radius, 0, 0}}, {101, 100, {-9 * radius, 0, 0}}};
  EXPECT_EQ(message_of_half(bed, 1),
            "particle 100: its contact history has a displacement too large for half precision");
  // To the letter of the paper displacements of contacts that slip grow on and on: here 10 radii in 100
  // steps.
  bed.particles.contact_history.clear();
  bed.model.slip_history = SlipHistory::paper;
  bed.walls = {{WallKind::plane, 0, bed.particles.position[0] - Vector3d(0, 0, 0.9 * radius),
                Vector3d::UnitZ(), Vector3d::Zero(), Vector3d::Zero()}};
  bed.particles.velocity[0].setZero();
  bed.particles.angular_velocity[0] = {0.1 / bed.time_step, 0, 0};
  bed.contacts.set(0, 0, {1, 1, 0, 1e-9});  // without friction nothing would be remembered
  bed.contacts.set(1, 0, {1, 1, 0, 1e-9});
  EXPECT_THAT(message_of_half(bed, 100),
              HasSubstr("has a tangential displacement too large for half precision"));
}

TEST(HalfHistory, IsRefusedForLawsWithoutHistory) {
  EXPECT_THAT(refusal(Variant::parse("simple/cells/cell/fp16_history/default")),
              HasSubstr("--contact simple has none"));
}

}  // namespace
}  // namespace warpgrain
