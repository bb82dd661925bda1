#include <cmath>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

#include "core/error.hpp"
#include "core/scene.hpp"
#include "core/state_file.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain {
namespace {

// The example of the format's description.
const std::string two_spheres =
    R"({ "format": "warpgrain.scene/1", "name": "two_spheres", "gravity": [0, 0, -9.81],
  "model": { "contact": "practical", "slip_history": "clip", "normal_force": "signed" },
  "materials": [ { "name": "glass", "density": 2500, "youngs_modulus": 1e7, "poisson_ratio": 0.3 } ],
  "contacts": [ { "between": ["glass", "glass"], "restitution": 0.8, "friction": 0.5 } ],
  "particles": [ { "material": "glass", "radius": 0.005, "position": [0,0,0], "velocity": [0,0,1], "angular_velocity": [0,0,0] },
                 { "material": "glass", "radius": 0.004, "position": [0,0,0.1] } ],
  "walls": [ { "material": "glass", "plane": { "point": [0,0,-1], "normal": [0,0,2] } },
             { "material": "glass", "rectangle": { "corner": [0,0,0.5], "edges": [[1,0,0],[0,1,0]] } } ],
  "time": { "step": "auto", "end": { "steps": 1000 } } })";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string message_of(const std::string& text, const SceneOverrides& overrides = {}) {
  try {
    parse_scene(text, "bed.json", overrides);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Scene, ReadsTheExampleOfTheFormat) {
  const Scene scene = parse_scene(two_spheres, "bed.json");
  EXPECT_EQ(scene.name, "two_spheres");
  EXPECT_EQ(scene.gravity, Vector3d(0, 0, -9.81));
  ASSERT_EQ(scene.particles.size(), 2u);
  EXPECT_EQ(scene.particles.id, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(scene.particles.velocity[0], Vector3d(0, 0, 1));
  EXPECT_EQ(scene.particles.velocity[1], Vector3d(0, 0, 0));
  EXPECT_DOUBLE_EQ(scene.particles.mass[0], 2500 * 4.0 / 3.0 * std::numbers::pi * std::pow(0.005, 3));
  EXPECT_EQ(scene.walls[0].kind, WallKind::plane);
  EXPECT_EQ(scene.walls[0].normal, Vector3d::UnitZ());
  EXPECT_EQ(scene.walls[1].kind, WallKind::rectangle);
  EXPECT_EQ(scene.walls[1].normal, Vector3d::UnitZ());
  EXPECT_EQ(scene.contacts.at(0, 0).friction_coefficient, 0.5);
  EXPECT_TRUE(scene.time_step_is_auto);
  EXPECT_GT(scene.time_step, 0);
  EXPECT_EQ(scene.end.steps, 1000u);
}

TEST(Scene, ContactsMayGiveTheModelsOwnParameters) {
  const Scene scene = parse_scene(replaced(two_spheres, R"("restitution": 0.8,)",
                                           R"("normal_parameter": 1e6, "tangential_parameter": 2e6,
                                              "damping_parameter": 0.1,)"),
                                  "bed.json");
  EXPECT_EQ(scene.contacts.at(0, 0).normal_parameter, 1e6);
  EXPECT_EQ(scene.contacts.at(0, 0).tangential_parameter, 2e6);
  EXPECT_EQ(scene.contacts.at(0, 0).damping_parameter, 0.1);
}

TEST(Scene, SimpleParametersAreGivenOrFollowFromThePracticalOnes) {
  const Scene derived = parse_scene(two_spheres, "bed.json");
  const double radius = 0.004, mass = derived.particles.mass[1];  // of the smallest
  const ContactParameters& contact = derived.contacts.at(0, 0);
  EXPECT_DOUBLE_EQ(derived.model.simple.k_spring,
                   contact.normal_parameter * std::sqrt(0.01 * radius * radius / 2));
  EXPECT_DOUBLE_EQ(derived.model.simple.k_damping,
                   contact.damping_parameter * std::sqrt(derived.model.simple.k_spring * mass / 2));
  EXPECT_DOUBLE_EQ(derived.model.simple.k_shear, 5 * derived.model.simple.k_damping);

  const Scene given = parse_scene(
      replaced(two_spheres, R"("contact": "practical")",
               R"("contact": "simple", "simple": { "k_spring": 9, "k_damping": 0.5, "k_shear": 0 })"),
      "bed.json");
  EXPECT_EQ(given.model.contact, ContactModel::simple);
  EXPECT_EQ(given.model.simple.k_spring, 9);
  EXPECT_EQ(given.model.simple.k_shear, 0);
}

struct BadScene {
  const char *from, *to, *message;
};

class SceneRefuses : public testing::TestWithParam<BadScene> {};

TEST_P(SceneRefuses, InOneLineThatNamesThePlace) {
  const std::string message = message_of(replaced(two_spheres, GetParam().from, GetParam().to));
  EXPECT_THAT(message, testing::HasSubstr(GetParam().message));
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    BadInput, SceneRefuses,
    testing::Values(
        BadScene{R"("gravity":)", R"("gravty":)", "bed.json: unknown key 'gravty'; valid: format, name,"},
        BadScene{R"("radius": 0.004)", R"("raduis": 0.004)",
                 "bed.json: particles[1]: unknown key 'raduis'; valid: material, radius,"},
        BadScene{R"("radius": 0.004)", R"("radius": 0)",
                 "bed.json: particles[1].radius: 0; expected a number above 0"},
        BadScene{R"("radius": 0.004)", R"("radius": -0.004)",
                 "bed.json: particles[1].radius: -0.004; expected"},
        BadScene{R"("radius": 0.004)", R"("radius": "4 mm")",
                 "bed.json: particles[1].radius: \"4 mm\"; expected a number"},
        BadScene{R"("radius": 0.004)", R"("radius": NaN)", "bed.json: line 6, column"},
        BadScene{R"("radius": 0.004)", R"("radius": 1e999)", "bed.json: number overflow parsing '1e999'"},
        BadScene{R"("radius": 0.004, )", "", "bed.json: particles[1]: 'radius' is missing"},
        BadScene{R"("radius": 0.004)", R"("radius": 0.004, "radius": 1)", "bed.json: key 'radius' twice"},
        BadScene{R"([0,0,0.1])", R"([0,0,null])",
                 "bed.json: particles[1].position[2]: null; expected a number"},
        BadScene{R"([0,0,0.1])", R"([0,0])",
                 "bed.json: particles[1].position: [0,0]; expected three numbers"},
        BadScene{
            R"([0,0,0.1])", R"([0,0,0])",
            "bed.json: particles: particles 0 and 1 start at the same point; expected different positions"},
        BadScene{R"({ "material": "glass", "radius": 0.004)", R"({ "material": "steel", "radius": 0.004)",
                 "bed.json: particles[1].material: unknown material 'steel'; valid: glass"},
        BadScene{R"("between": ["glass", "glass"])", R"("between": ["glass", "iron"])",
                 "bed.json: contacts[0].between[1]: unknown material 'iron'; valid: glass"},
        BadScene{R"({ "between": ["glass", "glass"], "restitution": 0.8, "friction": 0.5 })", "",
                 "bed.json: contacts: nothing between 'glass' and 'glass'; expected an entry for every pair"},
        BadScene{R"("restitution": 0.8)", R"("restitution": 1.2)",
                 "bed.json: contacts[0].restitution: 1.2; expected"},
        BadScene{R"("restitution": 0.8, )", "", "bed.json: contacts[0]: neither 'restitution' nor"},
        BadScene{R"("friction": 0.5)", R"("friction": 0.5, "damping_parameter": 0.1)",
                 "bed.json: contacts[0].damping_parameter: stands beside 'restitution'"},
        BadScene{R"("poisson_ratio": 0.3)", R"("poisson_ratio": 0.6)",
                 "bed.json: materials[0].poisson_ratio: 0.6"},
        BadScene{R"("normal": [0,0,2])", R"("normal": [0,0,0])",
                 "bed.json: walls[0].plane.normal: no direction"},
        BadScene{R"([[1,0,0],[0,1,0]])", R"([[1,0,0],[2,0,0]])",
                 "bed.json: walls[1].rectangle.edges: a wall without area"},
        BadScene{R"([[1,0,0],[0,1,0]])", R"([[1,0,0],[0,0,0]])",
                 "bed.json: walls[1].rectangle.edges: a wall without area"},
        BadScene{R"([[1,0,0],[0,1,0]])", R"([[1,0,0],[1,1,0]])",
                 "bed.json: walls[1].rectangle.edges: not perpendicular"},
        BadScene{R"("rectangle":)", R"("plane": {}, "rectangle":)", "bed.json: walls[1]: not one shape"},
        BadScene{
            R"("slip_history": "clip")", R"("slip_history": "cut")",
            "bed.json: model.slip_history: unknown slip history 'cut'; valid: clip, paper, lammps, liggghts"},
        BadScene{R"("step": "auto")", R"("step": "fast")",
                 "bed.json: time.step: 'fast'; expected seconds, or \"auto\""},
        BadScene{R"("step": "auto")", R"("step": 0)", "bed.json: time.step: 0; expected a number above 0"},
        BadScene{R"("steps": 1000)", R"("steps": 1000, "time": 1)",
                 "bed.json: time.end: not one end; expected exactly"},
        BadScene{R"("steps": 1000)", R"("steps": 10.5)",
                 "bed.json: time.end.steps: 10.5; expected a whole number"},
        BadScene{R"(scene/1)", R"(scene/2)",
                 "bed.json: format: 'warpgrain.scene/2'; expected 'warpgrain.scene/1'"},
        BadScene{R"("time":)", R"("domain": { "lower": [-1,-1,-1], "upper": [1,1,-1] }, "time":)",
                 "bed.json: domain: no volume"},
        BadScene{
            R"("time":)", R"("domain": { "lower": [-1,-1,-1], "upper": [1,1,0.05] }, "time":)",
            "bed.json: particles: particle 1 at (0, 0, 0.1) outside of the domain; expected a place between"},
        BadScene{R"("time":)", R"(, "time":)", "bed.json: line 9, column 3: syntax error"}));

TEST(Scene, RefusesWhatIsNoObjectAndWhatIsTooLarge) {
  EXPECT_THAT(message_of(""), testing::HasSubstr("bed.json: line 1, column 1"));
  EXPECT_THAT(message_of(std::string(100000, '[')), testing::HasSubstr("bed.json: nested too deeply"));
  EXPECT_THAT(message_of("[]"), testing::HasSubstr("bed.json: []; expected an object"));
  EXPECT_THAT(message_of(std::string(scene_size_limit + 1, ' ')),
              testing::HasSubstr("expected at most 67108864 bytes"));
}

TEST(Scene, OtherCountsAndSeedsNeedAFill) {
  SceneOverrides overrides;
  overrides.particles = 100;
  EXPECT_EQ(
      message_of(two_spheres, overrides),
      "bed.json: particles: no fill; expected a scene whose particles are a 'fill', for another number of "
      "particles or seed");
}

TEST(Scene, NamedScenesLoadAndSaySomethingOfThemselves) {
  std::vector<std::string> names;
  for (const SceneSummary& summary : named_scenes()) {
    names.push_back(summary.name);
    EXPECT_FALSE(summary.summary.empty());
    const Scene scene = load_scene(summary.name);
    EXPECT_EQ(scene.name, summary.name);
  }
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_THAT(names, testing::IsSupersetOf({"slit", "head_on", "oblique_wall", "settled_bed", "shear_box"}));
}

TEST(Scene, UnknownNamesAreAnsweredWithTheValidOnes) {
  EXPECT_THAT([] { load_scene("slitt"); }, testing::ThrowsMessage<InputError>(testing::StartsWith(
                                               "scene: unknown file or name 'slitt'; valid: free_fall, ")));
}

TEST(Scene, SlitKeepsItsShapeAtAnyCount) {
  const Scene paper = load_scene("slit");
  EXPECT_EQ(paper.particles.size(), 131072u);
  for (std::uint64_t count : {1u, 7u, 64u, 1000u, 4096u, 16384u}) {
    SceneOverrides overrides;
    overrides.particles = count;
    const Scene scene = load_scene("slit", overrides);
    EXPECT_EQ(scene.particles.size(), count);
    EXPECT_EQ(scene.particles.radius[0], paper.particles.radius[0]);
    const double stretch = scene.walls[6].point.x() / paper.walls[6].point.x();
    EXPECT_GE(stretch, std::cbrt(static_cast<double>(count) / 131072) * (1 - 1e-12));
    // Whole lattice cells cost the smallest fills some room.
    if (count >= 4096) {
      EXPECT_LE(stretch, std::cbrt(static_cast<double>(count) / 131072) * 1.03);
    }
    EXPECT_DOUBLE_EQ(scene.domain.upper.z(), stretch * paper.domain.upper.z());
    EXPECT_DOUBLE_EQ(scene.walls[5].edge_u.x(), stretch * paper.walls[5].edge_u.x());
  }
}

TEST(Scene, SeedsMoveTheFill) {
  SceneOverrides one, two;
  one.particles = two.particles = 200;
  one.seed = 1;
  two.seed = 2;
  EXPECT_NE(load_scene("slit", one).particles.position, load_scene("slit", two).particles.position);
  EXPECT_EQ(load_scene("slit", one).particles.position, load_scene("slit", one).particles.position);
}

class SceneFiles : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  TemporaryFolder folder_;
};

std::string with_particles(const std::string& particles) {
  const std::size_t begin = two_spheres.find(R"("particles":)"), end = two_spheres.find(R"("walls":)");
  return two_spheres.substr(0, begin) + "\"particles\": " + particles + ", " + two_spheres.substr(end);
}

TEST_F(SceneFiles, ParticlesComeFromAStateFileBesideTheScene) {
  write("bed.csv", "id,x,y,z,vz\n5,0,0,0,1.5\n3,0,0,0.1,0\n");
  const Scene scene = load_scene(
      write("scene.json", with_particles(R"({ "file": "bed.csv", "material": "glass", "radius": 0.005 })")));
  EXPECT_EQ(scene.particles.id, (std::vector<std::uint32_t>{5, 3}));
  EXPECT_EQ(scene.particles.velocity[0].z(), 1.5);
  EXPECT_GT(scene.particles.mass[1], 0);
}

TEST_F(SceneFiles, AStateFileCutInTheMiddleIsNamedWithItsLine) {
  write("bed.csv", "id,x,y,z,radius\n5,0,0,0,0.005\n3,0,0,0.1,0.0");
  const std::string scene =
      write("scene.json", with_particles(R"({ "file": "bed.csv", "material": "glass" })"));
  EXPECT_THAT([&] { load_scene(scene); }, testing::ThrowsMessage<InputError>(testing::HasSubstr(
                                              "bed.csv: line 3: the file ends within the line")));
}

TEST_F(SceneFiles, AFillThatDoesNotFitSaysHowManyWould) {
  const std::string message = message_of(with_particles(
      R"({ "fill": { "box": [[0,0,0.1],[0.1,0.1,0.2]], "count": 1001, "radius": 0.005 }, "material": "glass" })"));
  EXPECT_THAT(message,
              testing::HasSubstr("bed.json: particles.fill: 1001 spheres of radius 0.005 do not fit"));
}

TEST_F(SceneFiles, AMissingStateFileIsNamed) {
  const std::string scene =
      write("scene.json", with_particles(R"({ "file": "no.csv", "material": "glass" })"));
  EXPECT_THAT([&] { load_scene(scene); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("no.csv: no such file")));
}

}  // namespace
}  // namespace warpgrain
