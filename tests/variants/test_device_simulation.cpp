#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

#include "core/error.hpp"
#include "covering_variants.hpp"
#include "random_bed.hpp"
#include "variants/device_simulation.hpp"

namespace warpgrain {
namespace {

using testing::HasSubstr;

// Both orders, and what else goes through a step in a way of its own, in the precision whose rounding gives
// the input back as it was.
class Order : public testing::TestWithParam<const char*> {
 protected:
  std::unique_ptr<Simulation> create(const Scene& scene) const {
    return backend("opencl").create(scene, Variant::parse(GetParam()), {});
  }
};
INSTANTIATE_TEST_SUITE_P(Device, Order,
                         testing::Values("branchy/cells/cell/fp64/default",
                                         "branchy/cells/unsorted/fp64/default",
                                         "branchy/verlet/morton/fp64/default/sort=counting",
                                         "branchy/half_shell/unsorted/fp64/default",
                                         "branchy/two_phase/contact_count/fp64/default/reorder_every=4",
                                         "branchy/warp_per_cell/morton/fp64/default",
                                         "branchy/contact_list/cell/fp64/default/cell_size=2"),
                         [](const auto& variant) { return test_name(Variant::parse(variant.param)); });

void expect_equal(const ParticleState& a, const ParticleState& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.angular_velocity, b.angular_velocity);
  ASSERT_EQ(a.contact_history.size(), b.contact_history.size());
  for (std::size_t k = 0; k < a.contact_history.size(); ++k) {
    EXPECT_EQ(a.contact_history[k].particle_id, b.contact_history[k].particle_id);
    EXPECT_EQ(a.contact_history[k].partner_id, b.contact_history[k].partner_id);
    EXPECT_EQ(a.contact_history[k].tangential_displacement, b.contact_history[k].tangential_displacement);
  }
}

ParticleState sorted_by_id(const ParticleState& state) {
  std::vector<std::size_t> order(state.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::size_t k) { return state.id[k]; });
  ParticleState sorted;
  sorted.contact_history = state.contact_history;
  for (std::size_t k : order) {
    sorted.id.push_back(state.id[k]);
    sorted.material.push_back(state.material[k]);
    sorted.radius.push_back(state.radius[k]);
    sorted.mass.push_back(state.mass[k]);
    sorted.position.push_back(state.position[k]);
    sorted.velocity.push_back(state.velocity[k]);
    sorted.angular_velocity.push_back(state.angular_velocity[k]);
  }
  return sorted;
}

TEST_P(Order, GivesTheSceneBackBeforeTheFirstStep) {
  const Scene bed = random_bed({.n_particles = 1500, .seed = 3});
  expect_equal(create(bed)->state(), sorted_by_id(bed.particles));
}

TEST_P(Order, RepeatsItselfBitByBit) {
  const Scene bed = random_bed({.n_particles = 1500, .seed = 4});
  const auto first = create(bed), second = create(bed);
  first->step(20);
  for (int k = 0; k < 20; ++k) second->step(1);
  expect_equal(first->state(), second->state());
  EXPECT_EQ(first->forces().force, second->forces().force);
  EXPECT_EQ(first->contact_count(), second->contact_count());
}

std::string message_of(auto&& call) {
  try {
    call();
  } catch (const SimulationError& e) {
    return e.what();
  }
  return "no error";
}

// Sums run over partners in the order of (cell, rank), which does not depend on where they stand in memory.
TEST(DeviceSimulation, OrdersAgreeBitByBit) {
  const Scene bed = random_bed({.n_particles = 1500, .seed = 5});
  Variant variant;
  const auto cell = backend("opencl").create(bed, variant, {});
  cell->step(50);
  for (const char* name : {"branchy/cells/unsorted/fp32/default", "branchy/cells/contact_count/fp32/default",
                           "branchy/cells/cell/fp32/default/reorder_every=4"}) {
    SCOPED_TRACE(name);
    const auto other = backend("opencl").create(bed, Variant::parse(name), {});
    other->step(50);
    expect_equal(cell->state(), other->state());
    EXPECT_EQ(cell->forces().torque, other->forces().torque);
  }
}

std::uint64_t calls_of(const Simulation& simulation, std::string_view kernel) {
  for (const KernelTiming& timing : simulation.timings())
    if (timing.kernel == kernel) return timing.calls;
  return 0;
}

TEST(DeviceSimulation, MovesParticlesInMemoryAsOftenAsItIsTold) {
  const Scene bed = random_bed({.n_particles = 300});
  for (const std::uint64_t every : {1u, 4u, 16u}) {
    const std::string name = Variant().name() + "/reorder_every=" + std::to_string(every);
    const auto simulation = backend("opencl").create(bed, Variant::parse(name), {});
    simulation->step(31);
    EXPECT_EQ(calls_of(*simulation, "reorder_particles"), 32 / every);
    EXPECT_EQ(calls_of(*simulation, "map_particles"), 32u);
  }
}

// The map is the same however it has been sorted.
TEST(DeviceSimulation, SortsAgreeBitByBit) {
  const Scene bed = random_bed({.n_particles = 1500, .seed = 7});
  const auto bitonic = backend("opencl").create(bed, Variant(), {});
  const auto counting =
      backend("opencl").create(bed, Variant::parse(Variant().name() + "/sort=counting"), {});
  bitonic->step(50);
  counting->step(50);
  expect_equal(bitonic->state(), counting->state());
}

// Which work-item adds to a sum first is left to chance; the sums are not.
TEST(DeviceSimulation, SumsOfHalfShellsCanBeRepeated) {
  const Scene bed = random_bed({.n_particles = 1500, .seed = 11});
  const Variant variant = Variant::parse("branchy/half_shell/cell/fp32/default");
  const auto first = backend("opencl").create(bed, variant, {}),
             second = backend("opencl").create(bed, variant, {});
  first->step(20);
  second->step(20);
  expect_equal(first->state(), second->state());
  EXPECT_EQ(first->forces().force, second->forces().force);
}

TEST(DeviceSimulation, NamesAForceTooLargeForFixedPointSums) {
  Scene bed = random_bed({.n_particles = 8, .history = false});
  for (Vector3d& velocity : bed.particles.velocity) velocity *= 1e9;
  EXPECT_THAT(message_of([&] {
                backend("opencl").create(bed, Variant::parse("branchy/half_shell/cell/fp32/default"), {});
              }),
              HasSubstr("feels a force too large for fixed-point sums"));
}

// Fast grains that begin and end contacts at every step: all of them are found, though lists last for
// several.
TEST(DeviceSimulation, NeighbourListsMissNoContact) {
  Scene bed = random_bed({.n_particles = 1500, .seed = 9, .spacing = 2.1});
  for (Vector3d& velocity : bed.particles.velocity) velocity *= 20;
  const std::string precision_and_math = "/cell/fp64/default";
  const auto cells = backend("opencl").create(bed, Variant::parse("branchy/cells" + precision_and_math), {});
  const auto lists = backend("opencl").create(bed, Variant::parse("branchy/verlet" + precision_and_math), {});
  const auto groups =
      backend("opencl").create(bed, Variant::parse("branchy/cluster" + precision_and_math), {});
  for (int k = 0; k < 60; ++k) {
    for (const auto* simulation : {&lists, &groups, &cells}) (*simulation)->step(1);
    ASSERT_EQ(lists->contact_count(), cells->contact_count()) << "step " << k + 1;
    ASSERT_EQ(groups->contact_count(), cells->contact_count()) << "step " << k + 1;
  }
  for (const std::uint64_t listings :
       {calls_of(*lists, "list_neighbours"), calls_of(*groups, "list_groups")}) {
    EXPECT_GT(listings, 3u);
    EXPECT_LT(2 * listings, calls_of(*lists, "force_between_particles"));
  }
}

TEST(DeviceSimulation, NamesAParticleWithMoreNeighboursThanItsListHolds) {
  const Scene scene = random_bed({.n_particles = 1000, .spacing = 0.8, .history = false});
  EXPECT_THAT(message_of([&] {
                backend("opencl").create(scene, Variant::parse("simple/verlet/cell/fp32/default"), {});
              }),
              HasSubstr("has more neighbours than its list has room for"));
}

TEST_P(Order, ContinuesFromAState) {
  const Scene bed = random_bed({.n_particles = 1000, .seed = 6});
  Scene by_id = bed;
  by_id.particles = sorted_by_id(bed.particles);
  const auto whole = create(by_id);
  whole->step(7);
  Scene half = bed;
  half.particles = whole->state();
  const auto continued = create(half);
  whole->step(7);
  continued->step(7);
  expect_equal(whole->state(), continued->state());
}

// Long enough for contacts to begin, slip and end; short enough that rounding has not grown.
TEST_P(Order, FollowsTheReferenceOverAStretch) {
  const Scene bed = random_bed({.n_particles = 500, .seed = 8});
  const auto simulation = create(bed);
  Variant variant;
  variant.set("precision", "fp64");
  const auto reference = backend("host").create(bed, variant, {});
  simulation->step(100);
  reference->step(100);
  const ParticleState state = simulation->state(), expected = reference->state();
  EXPECT_EQ(simulation->steps_done(), 100u);
  EXPECT_NE(reference->contact_count(), backend("host").create(bed, variant, {})->contact_count());
  EXPECT_EQ(simulation->contact_count(), reference->contact_count());
  for (std::size_t k = 0; k < state.size(); ++k) {
    ASSERT_EQ(state.id[k], expected.id[k]);
    EXPECT_LE((state.position[k] - expected.position[k]).norm(), 1e-12);
    EXPECT_LE((state.velocity[k] - expected.velocity[k]).norm(), 1e-8);
    EXPECT_LE((state.angular_velocity[k] - expected.angular_velocity[k]).norm(), 1e-5);
  }
}

TEST(DeviceSimulation, TimesEveryKernelOfTheFlow) {
  const auto simulation = backend("opencl").create(random_bed({.n_particles = 3000}), Variant(), {});
  simulation->step(5);
  std::vector<std::string> kernels;
  for (const KernelTiming& timing : simulation->timings()) {
    kernels.push_back(timing.kernel);
    EXPECT_GE(timing.calls, 5u);
    EXPECT_GT(timing.seconds, 0);
  }
  EXPECT_THAT(kernels,
              testing::UnorderedElementsAre("integrate", "map_particles", "sort_blocks", "merge_stride",
                                            "merge_blocks", "reorder_particles", "clear_cells", "find_cells",
                                            "force_between_particles", "force_from_walls"));
}

Scene single_particle() {
  Scene scene = random_bed({.n_particles = 1, .history = false});
  scene.walls.clear();
  scene.gravity.setZero();
  scene.particles.id = {42};
  scene.particles.position[0].setZero();
  scene.domain = {Vector3d::Constant(-0.1), Vector3d::Constant(0.1)};
  scene.time_step = 1e-3;
  return scene;
}

TEST_P(Order, NamesTheParticleThatLeavesTheDomainAndTheStep) {
  Scene scene = single_particle();
  scene.particles.velocity[0] = {0, 0, 10.5};  // 0.0105 m a step: outside after the tenth
  const auto simulation = create(scene);
  EXPECT_EQ(message_of([&] { simulation->step(1000); }), "step 10: particle 42 left the domain");
  EXPECT_EQ(message_of([&] { simulation->state(); }), "step 10: particle 42 left the domain");
  EXPECT_EQ(message_of([&] { simulation->step(1); }), "step 10: particle 42 left the domain");
}

TEST_P(Order, NamesAParticleThatIsOutsideFromTheStart) {
  Scene scene = single_particle();
  scene.particles.position[0] = {0.2, 0, 0};
  EXPECT_EQ(message_of([&] { create(scene); }), "step 0: particle 42 left the domain");
}

TEST_P(Order, NamesAParticleThatIsNotANumber) {
  Scene scene = single_particle();
  scene.particles.position[0].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message_of([&] { create(scene); }),
              HasSubstr("step 0: particle 42 has a position or a force that is not"));
}

TEST_P(Order, NoticesAForceThatIsNotANumberInTheStepOfItsMaking) {
  Scene scene = random_bed({.n_particles = 2, .history = false});
  scene.particles.position[1] = scene.particles.position[0];
  EXPECT_THAT(message_of([&] { create(scene); }), HasSubstr("step 0: particle 10"));
}

TEST_P(Order, NamesAParticleWithMoreContactsThanSlots) {
  Scene scene = random_bed({.n_particles = 27, .spacing = 0.8, .history = false});
  EXPECT_THAT(message_of([&] { create(scene); }), HasSubstr("has more contacts than contact slots"));
  scene.particles.contact_history.clear();
  for (std::uint32_t partner = 101; partner < 127; ++partner) {
    scene.particles.contact_history.push_back({100, partner, Vector3d::Zero()});
  }
  EXPECT_THAT(message_of([&] { create(scene); }),
              HasSubstr("particle 100: its contact history has more than"));
}

}  // namespace
}  // namespace warpgrain
