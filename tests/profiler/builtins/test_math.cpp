// Every function of real numbers within OpenCL's limits, as docs/builtins.md says, in scalars and vectors.

#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "tests/paths.hpp"
#include "tests/profiler/builtins/documentation.hpp"
#include "tests/profiler/builtins/random.hpp"

namespace warpgrain::profiler::builtins {
namespace {

void expect_within_limits(const std::vector<Measurement>& measured) {
  for (const Measurement& m : measured) {
    EXPECT_GT(m.samples, 100U) << m.function;
    EXPECT_LE(m.worst, m.limit) << fmt::format("{}, seed {}, error {}: {}", m.function, seed, m.worst,
                                               m.worst_case);
  }
}

std::string documented() {
  std::ifstream in(source_path("docs/builtins.md"));
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

class MathFunctions : public testing::TestWithParam<std::size_t> {};

TEST_P(MathFunctions, KeepTheirLimitsAsDocumented) {
  const Section section = sections()[GetParam()];
  const SectionMeasurements measured = measure(section);
  expect_within_limits(measured.in_float);
  expect_within_limits(measured.in_double);
  const std::string page = documented();
  for (const std::string& row : rows(section, measured))
    EXPECT_NE(page.find(row + "\n"), std::string::npos) << "docs/builtins.md has no row\n" << row;
}

TEST_P(MathFunctions, GiveTheSameInVectors) {
  const Section section = sections()[GetParam()];
  EXPECT_EQ(differences_in_vectors<float>(section.functions, 3), std::vector<std::string>());
  if (section.title.find("half_") != std::string_view::npos) return;
  EXPECT_EQ(differences_in_vectors<double>(section.functions, 3), std::vector<std::string>());
}

INSTANTIATE_TEST_SUITE_P(Sections, MathFunctions, testing::Values(0, 1, 2, 3));

}  // namespace
}  // namespace warpgrain::profiler::builtins
