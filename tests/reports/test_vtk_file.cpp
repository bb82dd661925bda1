#include <cstring>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "reports/vtk_file.hpp"
#include "run_python.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

ParticleState two_particles() {
  ParticleState state;
  state.id = {7, 9};
  state.material = {0, 0};
  state.radius = {0.5, 0.25};
  state.mass = {1, 1};
  state.position = {Vector3d(1, 2, 3), Vector3d(4, 5, 6)};
  state.velocity = {Vector3d(0, 0, -1), Vector3d(0, 0, 1)};
  state.angular_velocity = {Vector3d(1, 0, 0), Vector3d(0, 1, 0)};
  return state;
}

TEST(VtkFile, BlocksStandAtTheirOffsets) {
  const TemporaryFolder folder;
  const auto path = folder / "two.vtp";
  write_vtk_particles(path, two_particles());
  std::ifstream in(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const auto data = text.find("<AppendedData encoding=\"raw\">\n_");
  ASSERT_NE(data, std::string::npos);
  const auto first = data + std::string("<AppendedData encoding=\"raw\">\n_").size();

  const auto offset_of = [&](const std::string& name) {
    const auto array = text.find("Name=\"" + name + "\"");
    return std::stoul(text.substr(text.find("offset=\"", array) + 8));
  };
  const auto block = [&](const std::string& name, auto* values, std::size_t n) {
    const char* start = text.data() + first + offset_of(name);
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, start, sizeof bytes);
    ASSERT_EQ(bytes, n * sizeof *values) << name;
    std::memcpy(values, start + sizeof bytes, bytes);
  };
  float position[6];
  block("position", position, 6);
  EXPECT_EQ(position[3], 4.0f);
  std::uint32_t id[2];
  block("id", id, 2);
  EXPECT_EQ(id[1], 9u);
  float spin[6];
  block("angular_velocity", spin, 6);
  EXPECT_EQ(spin[4], 1.0f);
}

// Two particles that overlap by 0.1, the first of which touches the floor, too.
Scene scene_of_contacts() {
  Scene scene;
  scene.domain = {Vector3d(-1, -1, -1), Vector3d(2, 2, 2)};
  scene.walls = {Wall{}};  // z = 0
  scene.particles = two_particles();
  scene.particles.position = {Vector3d(0, 0, 0.375), Vector3d(0, 0.65, 0.375)};
  scene.particles.contact_history = {{7, 9, Vector3d(0.5, 0, 0)}, {9, 7, Vector3d(-0.5, 0, 0)}};
  return scene;
}

// As ParaView reads them.
TEST(VtkFile, IsReadByVtksOwnReader) {
  const TemporaryFolder folder;
  const Scene scene = scene_of_contacts();
  write_vtk_particles(folder / "particles.vtp", scene.particles);
  write_vtk_contacts(folder / "contacts.vtp", scene, scene.particles);
  ParticleState apart = scene.particles;
  apart.position = {Vector3d(1, 1, 1), Vector3d(0, 0, 1)};
  write_vtk_contacts(folder / "none.vtp", scene, apart);
  const auto answers =
      run_python("read_vtk.py", {folder / "particles.vtp", folder / "contacts.vtp", folder / "none.vtp"});
  ASSERT_FALSE(answers.empty());
  if (answers[0] == "no vtk") GTEST_SKIP() << "no vtk of Python (python3-vtk9)";
  const nlohmann::json particles = nlohmann::json::parse(answers.at(0)),
                       contacts = nlohmann::json::parse(answers.at(1));
  EXPECT_EQ(particles["cells"], nlohmann::json::parse("[[0], [1]]"));
  EXPECT_EQ(particles["points"][0], nlohmann::json::parse("[0, 0, 0.375]"));
  EXPECT_EQ(particles["point_data"]["id"], nlohmann::json::parse("[[7], [9]]"));
  EXPECT_EQ(particles["point_data"]["velocity"], nlohmann::json::parse("[[0, 0, -1], [0, 0, 1]]"));
  EXPECT_EQ(contacts["cells"], nlohmann::json::parse("[[0, 1], [2, 3]]"));
  const nlohmann::json& of = contacts["cell_data"];
  EXPECT_EQ(of["particle"], nlohmann::json::parse("[[7], [7]]"));
  EXPECT_EQ(of["partner"], nlohmann::json::parse("[[9], [2147483648]]"));
  EXPECT_NEAR(of["overlap"][0][0].get<double>(), 0.1, 1e-6);
  EXPECT_NEAR(of["overlap"][1][0].get<double>(), 0.125, 1e-6);
  EXPECT_EQ(of["tangential_displacement"], nlohmann::json::parse("[[0.5, 0, 0], [0, 0, 0]]"));
  EXPECT_EQ(contacts["points"][3], nlohmann::json::parse("[0, 0, 0]")) << "the nearest point of the floor";
  EXPECT_EQ(nlohmann::json::parse(answers.at(2))["cells"], nlohmann::json::array());
}

TEST(VtkFile, ContactsAreLinesWithTheirPartners) {
  const TemporaryFolder folder;
  const Scene scene = scene_of_contacts();
  write_vtk_contacts(folder / "contacts.vtp", scene, scene.particles);
  std::ifstream in(folder / "contacts.vtp", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(text, testing::HasSubstr("NumberOfPoints=\"4\" NumberOfVerts=\"0\" NumberOfLines=\"2\""));
  for (const char* name : {"particle", "partner", "overlap", "tangential_displacement"})
    EXPECT_THAT(text, testing::HasSubstr(std::string("Name=\"") + name + "\""));
}

TEST(VtkFile, NamesAFolderThatCannotBeMade) {
  EXPECT_THROW(write_vtk_particles("/proc/no/such/place.vtp", two_particles()), InputError);
}

}  // namespace
}  // namespace warpgrain::reports
