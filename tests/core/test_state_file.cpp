#include <cmath>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include "core/error.hpp"
#include "core/state_file.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain {
namespace {

ParticleState random_state(std::size_t n) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-300, 300);
  const auto number = [&] { return std::ldexp(mantissa(random), exponent(random)); };
  ParticleState state;
  for (std::uint32_t k = 0; k < n; ++k) {
    state.id.push_back(7 * k);
    state.position.emplace_back(number(), number(), number());
    state.velocity.emplace_back(number(), number(), -0.0);
    state.angular_velocity.emplace_back(number(), 0.1, std::numeric_limits<double>::denorm_min());
    state.radius.push_back(std::abs(number()));
  }
  return state;
}

TEST(StateFile, ReadsBackTheSameDoubles) {
  const ParticleState written = random_state(200);
  const ParticleState read = parse_state_csv(format_state_csv(written), "state.csv");
  EXPECT_EQ(read.id, written.id);
  EXPECT_EQ(read.position, written.position);
  EXPECT_EQ(read.velocity, written.velocity);
  EXPECT_EQ(read.angular_velocity, written.angular_velocity);
  EXPECT_EQ(read.radius, written.radius);
}

TEST(StateFile, HeaderIsTheContracts) {
  EXPECT_EQ(format_state_csv({}), "id,x,y,z,vx,vy,vz,wx,wy,wz,radius\n");
}

TEST(StateFile, IgnoresColumnsAndTakesMissingVelocitiesAsZero) {
  const ParticleState state = parse_state_csv("mass,z,y,x,id\r\n9,3,2,1,4\r\n", "state.csv", 0.5);
  EXPECT_EQ(state.id, std::vector<std::uint32_t>{4});
  EXPECT_EQ(state.position[0], Vector3d(1, 2, 3));
  EXPECT_EQ(state.velocity[0], Vector3d(0, 0, 0));
  EXPECT_EQ(state.radius[0], 0.5);
}

struct BadState {
  const char *text, *message;
};

class StateFileRefuses : public testing::TestWithParam<BadState> {};

TEST_P(StateFileRefuses, NamingTheLine) {
  EXPECT_THAT([] { parse_state_csv(GetParam().text, "state.csv"); },
              testing::ThrowsMessage<InputError>(testing::StartsWith(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(
    BadInput, StateFileRefuses,
    testing::Values(
        BadState{"", "state.csv: empty; expected a header line: id,x"},
        BadState{"id,x,y,radius\n", "state.csv: line 1: no column 'z'"},
        BadState{"id,x,y,z\n", "state.csv: line 1: no column 'radius'"},
        BadState{"id,x,y,z,x,radius\n", "state.csv: line 1: column 'x' twice"},
        BadState{"id,x,y,z,radius\n0,1,2,3,4\n1,1,2", "state.csv: line 3: the file ends within the line"},
        BadState{"id,x,y,z,radius\n0,1,2,3,4", "state.csv: line 2: the file ends within the line"},
        BadState{"id,x,y,z,radius\n0,1,2,3\n", "state.csv: line 2: 4 fields; expected 5 as in the header"},
        BadState{"id,x,y,z,radius\n0,1,2,3,4,5\n",
                 "state.csv: line 2: 6 fields; expected 5 as in the header"},
        BadState{"id,x,y,z,radius\n0,1,nan,3,4\n",
                 "state.csv: line 2: column 'y': 'nan'; expected a finite number"},
        BadState{"id,x,y,z,radius\n0,1,1e999,3,4\n", "state.csv: line 2: column 'y': '1e999'"},
        BadState{"id,x,y,z,radius\n0,1,,3,4\n", "state.csv: line 2: column 'y': ''"},
        BadState{"id,x,y,z,radius\n0,1,2 ,3,4\n", "state.csv: line 2: column 'y': '2 '"},
        BadState{"id,x,y,z,radius\n-1,1,2,3,4\n", "state.csv: line 2: column 'id': '-1'"},
        BadState{"id,x,y,z,radius\n2147483648,1,2,3,4\n", "state.csv: line 2: column 'id': '2147483648'"},
        BadState{"id,x,y,z,radius\n0,1,2,3,4\n0,2,2,3,4\n", "state.csv: line 3: id 0 twice"},
        BadState{"id,x,y,z,radius\n0,1,2,3,0\n", "state.csv: line 2: radius 0; expected a radius above 0"}));

TEST(StateFile, WritesWholeFilesOrNone) {
  const TemporaryFolder folder;
  write_state_file(folder / "state.csv", random_state(3));
  EXPECT_EQ(read_state_file(folder / "state.csv").size(), 3u);
  EXPECT_THROW(write_state_file(folder / "missing" / "state.csv", random_state(3)), InputError);
  std::filesystem::create_directories(folder / "taken.csv");
  EXPECT_THROW(write_state_file(folder / "taken.csv", random_state(3)), InputError);
  std::size_t n_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    n_files += entry.is_regular_file();
  EXPECT_EQ(n_files, 1u);  // no unfinished ones
}

}  // namespace
}  // namespace warpgrain
