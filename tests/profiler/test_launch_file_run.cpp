// Launch files whose output oclgrind-kernel 21.10 printed: data/oclgrind/NAME.sim with its program, and
// NAME.dump, the standard output of `oclgrind-kernel --num-threads 1 NAME.sim`.

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "profiler/launch_file.hpp"
#include "tests/paths.hpp"

namespace warpgrain::profiler {
namespace {

std::vector<std::string> names() {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(source_path("tests/profiler/data/oclgrind"))))
    if (entry.path().extension() == ".sim") found.push_back(entry.path().stem().string());
  std::sort(found.begin(), found.end());
  return found;
}

class OutputOfOclgrind : public testing::TestWithParam<std::string> {};

TEST_P(OutputOfOclgrind, IsTheSameToTheByteWithOneThreadAndWithSeveral) {
  const std::filesystem::path base =
      std::filesystem::path(source_path("tests/profiler/data/oclgrind")) / GetParam();
  std::ostringstream expected;
  expected << std::ifstream(base.string() + ".dump", std::ios::binary).rdbuf();
  const LaunchFile file = read_launch_file(base.string() + ".sim");
  for (const unsigned threads : {1U, 3U}) {
    ProfileOptions options;
    options.threads = threads;
    std::ostringstream printed;
    profile_launch_file(file, "", options, printed);
    EXPECT_EQ(printed.str(), expected.str()) << threads << " threads";
  }
}

INSTANTIATE_TEST_SUITE_P(Launches, OutputOfOclgrind, testing::ValuesIn(names()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace warpgrain::profiler
