// The model without what a scene can do without: the rules one by one, the same trajectories as with the full
// model, and, on random scenes, the double reference, which always has all of it.

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <string>

#include "core/error.hpp"
#include "core/reference_forces.hpp"
#include "covering_variants.hpp"
#include "random_bed.hpp"
#include "variants/backend.hpp"
#include "variants/combinations.hpp"
#include "variants/device_scene.hpp"
#include "variants/scene_features.hpp"

namespace warpgrain {
namespace {

using enum FeatureId;

using Change = std::function<void(Scene&)>;

void change_pairs(Scene& scene, const std::function<void(ContactParameters&)>& change) {
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t b = a; b < 2; ++b) {
      ContactParameters p = scene.contacts.at(a, b);
      change(p);
      scene.contacts.set(a, b, p);
    }
}
void without_friction(Scene& scene) {
  change_pairs(scene, [](ContactParameters& p) { p.friction_coefficient = 0; });
}
void without_damping(Scene& scene) {
  change_pairs(scene, [](ContactParameters& p) { p.damping_parameter = 0; });
  scene.model.simple.k_damping = 0;
}
void without_springs(Scene& scene) {
  change_pairs(scene, [](ContactParameters& p) { p.tangential_parameter = 0; });
}
void of_one_pair(Scene& scene) {
  change_pairs(scene, [](ContactParameters& p) { p = {7.3e6, 1.2e7, 0.4, 0.5}; });
}
void of_one_radius(Scene& scene) { std::ranges::fill(scene.particles.radius, 0.0047); }
void of_one_mass(Scene& scene) { std::ranges::fill(scene.particles.mass, 0.0011); }
void of_one_material(Scene& scene) {
  of_one_radius(scene);
  of_one_mass(scene);
  std::ranges::fill(scene.particles.material, 0u);
}
void without_gravity(Scene& scene) { scene.gravity.setZero(); }
void without_shear(Scene& scene) { scene.model.simple.k_shear = 0; }
void keep_walls(Scene& scene, std::optional<WallKind> kind) {
  std::erase_if(scene.walls, [&](const Wall& wall) { return wall.kind != kind; });
  auto& history = scene.particles.contact_history;
  std::erase_if(history, [](const ContactRecord& c) { return (c.partner_id & wall_partner_bit) != 0; });
}
void without_walls(Scene& scene) { keep_walls(scene, {}); }
void planes_alone(Scene& scene) { keep_walls(scene, WallKind::plane); }
void rectangles_alone(Scene& scene) { keep_walls(scene, WallKind::rectangle); }
void repulsive(Scene& scene) { scene.model.normal_force = NormalForce::repulsive; }
void smallest(Scene& scene) {
  without_friction(scene);
  without_damping(scene);
  of_one_material(scene);
  without_gravity(scene);
  without_walls(scene);
}

Scene changed_bed(const std::vector<Change>& changes, std::size_t n = 150, std::uint64_t seed = 21) {
  Scene scene = random_bed({.n_particles = n, .seed = seed});
  for (const Change& change : changes) change(scene);
  return scene;
}

std::vector<std::string> left_out(const Scene& scene, const Variant& variant = {}) {
  std::vector<std::string> names;
  const SceneFeatures features = features_of(scene, variant);
  for (const Feature& row : features.rows())
    if (!row.is_modelled) names.emplace_back(row.name);
  return names;
}

using Names = std::vector<std::string>;

TEST(SceneFeatures, LeaveOutWhatTheRulesSay) {
  EXPECT_EQ(left_out(changed_bed({})), Names{"repulsion"});  // normal_force is signed: an option, not a part
  EXPECT_EQ(left_out(changed_bed({repulsive})), Names{});
  EXPECT_EQ(left_out(changed_bed({repulsive, without_damping})), (Names{"damping", "repulsion"}));
  EXPECT_EQ(left_out(changed_bed({without_friction})),
            (Names{"rotation", "friction", "history", "repulsion"}));
  EXPECT_EQ(left_out(changed_bed({without_springs})), (Names{"history", "repulsion"}));
  EXPECT_EQ(left_out(changed_bed({without_springs, without_damping})),
            (Names{"rotation", "friction", "history", "damping", "repulsion"}));
  EXPECT_EQ(left_out(changed_bed({of_one_pair})), (Names{"repulsion", "pair_materials", "wall_materials"}));
  EXPECT_EQ(left_out(changed_bed({of_one_material})),
            (Names{"repulsion", "radii", "masses", "pair_materials"}));
  EXPECT_EQ(left_out(changed_bed({without_gravity})), (Names{"repulsion", "gravity"}));
  EXPECT_EQ(left_out(changed_bed({planes_alone})), (Names{"repulsion", "rectangles"}));
  EXPECT_EQ(left_out(changed_bed({rectangles_alone})), (Names{"repulsion", "planes"}));
  EXPECT_EQ(left_out(changed_bed({smallest})).size(), n_features);
}

// With liggghts eq. (5) tests the spring alone: damping stays where mu = 0.
TEST(SceneFeatures, KeepTheDampingThatLiggghtsDoesNotCut) {
  const Change liggghts = [](Scene& scene) { scene.model.slip_history = SlipHistory::liggghts; };
  EXPECT_EQ(left_out(changed_bed({liggghts, without_friction})), Names{"repulsion"});
  EXPECT_EQ(left_out(changed_bed({liggghts, without_friction, without_damping})),
            (Names{"rotation", "friction", "history", "damping", "repulsion"}));
}

TEST(SceneFeatures, OfTheSimpleModelAreItsOwn) {
  const Variant simple = Variant::parse("simple/cells/cell/fp32/default");
  const Names never{"rotation", "history", "repulsion", "pair_materials", "wall_materials"};
  EXPECT_EQ(left_out(changed_bed({}), simple), never);
  EXPECT_EQ(
      left_out(changed_bed({without_shear, without_damping}), simple),
      (Names{"rotation", "friction", "history", "damping", "repulsion", "pair_materials", "wall_materials"}));
}

TEST(SceneFeatures, ComeBackWithOneNumberOfTheScene) {
  Scene scene = changed_bed({smallest});
  const auto needs = [&](FeatureId feature) { return features_of(scene, {}).model(feature); };
  ContactParameters pair = scene.contacts.at(0, 0);
  EXPECT_FALSE(needs(friction));
  pair.friction_coefficient = 0.1;
  scene.contacts.set(0, 0, pair);
  EXPECT_TRUE(needs(friction) && needs(rotation) && needs(history));
  EXPECT_FALSE(needs(damping));
  pair.damping_parameter = 1e-9;
  scene.contacts.set(0, 0, pair);
  EXPECT_TRUE(needs(damping));
  EXPECT_FALSE(needs(radii));
  scene.particles.radius[17] *= 1 + 1e-15;
  EXPECT_TRUE(needs(radii));
  EXPECT_FALSE(needs(gravity));
  scene.gravity.y() = 1e-300;
  EXPECT_TRUE(needs(gravity));
  // Pairs that never meet decide nothing; those at a wall do.
  EXPECT_FALSE(needs(pair_materials));
  scene.walls = random_bed({.n_particles = 8}).walls;
  EXPECT_TRUE(needs(wall_materials));
}

TEST(SceneFeatures, FullModelHasAll) {
  const Variant full = Variant::parse("branchy/cells/cell/fp32/default/model=full");
  EXPECT_EQ(left_out(changed_bed({smallest, repulsive}), full), Names{});
  const DeviceScene here = lay_out(changed_bed({smallest}), {}),
                    there = lay_out(changed_bed({smallest}), full);
  EXPECT_LT(2 * device_bytes(here), device_bytes(there));
  for (const DeviceArray array : {DeviceArray::angular_velocity, DeviceArray::torque, DeviceArray::walls,
                                  DeviceArray::history_partners, DeviceArray::contact_parameters})
    EXPECT_EQ(here.bytes[array], 0u);
}

TEST(SceneFeatures, KernelsOfAFolderHaveTheFullModel) {
  BackendOptions how;
  how.kernel_folder = ".";
  EXPECT_THROW(backend("opencl").create(changed_bed({}), {}, how), InputError);
}

void expect_same(const Scene& scene, const Variant& variant, const Backend& on, std::uint64_t steps) {
  SCOPED_TRACE(variant.name());
  Variant full = variant;
  full.set("model", "full");
  const auto here = on.create(scene, variant, {}), there = on.create(scene, full, {});
  here->step(steps);
  there->step(steps);
  const ParticleState a = here->state(), b = there->state();
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.angular_velocity, b.angular_velocity);
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(here->forces().force, there->forces().force);
  EXPECT_EQ(here->forces().torque, there->forces().torque);
  EXPECT_EQ(here->contact_count(), there->contact_count());
  EXPECT_GT(here->contact_count(), 0u);
}

struct Omission {
  const char* name;
  std::vector<Change> changes;
  const char* variant;
};

class Omissions : public testing::TestWithParam<Omission> {};
class OmissionsSimulated : public Omissions {};

// Bit by bit: division rounds as IEEE 754 has it on CPUs. Spins of the bed are not zero: where rotation is
// left out they stay.
TEST_P(Omissions, ChangeNoBitOnOpenCl) {
  expect_same(changed_bed(GetParam().changes), Variant::parse(GetParam().variant), backend("opencl"), 12);
}
TEST_P(OmissionsSimulated, ChangeNoBit) {
  if (const std::string lacks = backend("simt").lacks(); !lacks.empty()) GTEST_SKIP() << lacks;
  expect_same(changed_bed(GetParam().changes, 60), Variant::parse(GetParam().variant), backend("simt"), 3);
}

// Each part of the model once, laws and searches dealt out; then what goes together.
INSTANTIATE_TEST_SUITE_P(
    Parts, Omissions,
    testing::Values(
        Omission{"friction", {without_friction}, "branchy/two_phase/cell/fp32/default"},
        Omission{"history", {without_springs}, "branchless/cells/cell/fp32/default"},
        Omission{"damping", {without_damping}, "sfu_minimised/verlet/cell/fp32/default"},
        Omission{"repulsion", {repulsive, without_damping}, "branchy/cells/unsorted/fp64/default"},
        Omission{"gravity", {without_gravity}, "branchy/half_shell/cell/fp32/default"},
        Omission{"radii", {of_one_radius}, "sfu_minimised/half_shell/cell/fp32/default"},
        Omission{"masses", {of_one_mass}, "branchless/contact_list/cell/fp32/default"},
        Omission{"materials", {of_one_pair}, "branchy/contact_list/cell/mixed/default"},
        Omission{"pair_materials", {of_one_material}, "sfu_minimised/cells/cell/fp64/default"},
        Omission{"planes", {rectangles_alone}, "branchy/cells/cell/fp32/default"},
        Omission{"rectangles", {planes_alone}, "branchless/two_phase/morton/fp32/default/sort=counting"},
        Omission{"walls", {without_walls}, "simple/contact_list/cell/fp32/default"},
        Omission{"shear", {without_shear}, "simple/cells/cell/fp32/default"},
        Omission{"all", {smallest}, "branchy/half_shell/cell/fp32/default"},
        Omission{"all_of_simple", {smallest, without_shear}, "simple/half_shell/cell/mixed/default"}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

// The simulator runs the same kernels.
INSTANTIATE_TEST_SUITE_P(
    Parts, OmissionsSimulated,
    testing::Values(
        Omission{"friction", {without_friction}, "branchy/two_phase/cell/fp32/default"},
        Omission{"materials", {of_one_pair}, "branchy/contact_list/cell/mixed/default"},
        Omission{"rectangles", {planes_alone}, "branchless/two_phase/morton/fp32/default/sort=counting"},
        Omission{"all", {smallest}, "branchy/half_shell/cell/fp32/default"}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

// Random combinations, laws and searches against the double reference, within the variants' bounds.
TEST(SceneFeatures, RandomScenesAgreeWithTheDoubleReference) {
  constexpr std::uint64_t seed = 5;
  std::mt19937 random(seed);
  const auto once_in = [&](unsigned n) { return random() % n == 0; };
  for (int k = 0; k < 5; ++k) {
    std::vector<Change> changes;
    for (void (*change)(Scene&) :
         {without_friction, without_damping, without_springs, of_one_pair, of_one_radius, of_one_mass,
          of_one_material, without_gravity, without_shear, repulsive})
      if (once_in(3)) changes.emplace_back(change);
    if (once_in(2))
      changes.emplace_back(once_in(2) ? without_walls : once_in(2) ? planes_alone : rectangles_alone);
    Scene scene = changed_bed(changes, 200, random());
    scene.model.slip_history = static_cast<SlipHistory>(random() % slip_history_names.size());
    Variant variant;
    for (const AxisId id : {AxisId::contact, AxisId::search, AxisId::order}) {
      const Axis& axis = axes()[static_cast<std::size_t>(id)];
      variant.set(axis.name, axis.values[random() % axis.values.size()].name);
    }
    std::string names;
    for (const std::string& name : left_out(scene, variant)) names += ' ' + name;
    SCOPED_TRACE(variant.name() + " without" + names + ", scene " + std::to_string(k) + " of seed " +
                 std::to_string(seed));
    const auto simulation = backend("opencl").create(scene, variant, {});
    simulation->step(2);
    scene.model.contact = contact_law(variant).model;
    const ParticleState state = simulation->state();
    // A model without tangential springs remembers none; the reference goes on from the state's history.
    const ForceState expected = evaluate_forces(scene, state, scene.time_step,
                                                {.threads = 1, .contact_slots = contact_slots_for(state)})
                                    .forces;
    double scale = 0, worst = 0, worst_torque = 0;
    const ForceState forces = simulation->forces();
    for (std::size_t i = 0; i < state.size(); ++i) {
      scale = std::max(scale, expected.force[i].norm());
      worst = std::max(worst, (forces.force[i] - expected.force[i]).norm());
      worst_torque = std::max(worst_torque, (forces.torque[i] - expected.torque[i]).norm());
    }
    EXPECT_LE(worst, scale * error_bound(variant));
    EXPECT_LE(worst_torque, scale * error_bound(variant) * std::ranges::max(state.radius));
  }
}

}  // namespace
}  // namespace warpgrain
