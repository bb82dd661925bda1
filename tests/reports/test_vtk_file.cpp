#include <cstring>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>

#include "core/error.hpp"
#include "reports/vtk_file.hpp"
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

TEST(VtkFile, NamesAFolderThatCannotBeMade) {
  EXPECT_THROW(write_vtk_particles("/proc/no/such/place.vtp", two_particles()), InputError);
}

}  // namespace
}  // namespace warpgrain::reports
