// The simulator against an independent interpreter that issues every instruction for all active lanes of a
// warp at once (tests/profiler/oracle): every kernel of the test data, every policy, widths 8 and 32.

#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "profiler/launch_arguments.hpp"
#include "profiler/launch_file.hpp"
#include "profiler/opencl_frontend.hpp"
#include "tests/profiler/oracle/comparison.hpp"

namespace warpgrain::profiler {
namespace {

const std::filesystem::path data = WARPGRAIN_TEST_DATA_DIR;

std::vector<std::string> launch_files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(data))
    if (entry.path().extension() == ".sim") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

class OracleOnData : public testing::TestWithParam<std::string> {};

TEST_P(OracleOnData, AgreesInEveryCount) {
  const LaunchFile file = read_launch_file(data / (GetParam() + ".sim"));
  std::ifstream in(file.program);
  std::ostringstream text;
  text << in.rdbuf();
  const bool is_ptx = file.program.extension() == ".ptx";
  const std::string ptx = is_ptx ? text.str() : compile_opencl(text.str(), file.program.string()).ptx;
  std::vector<ParameterDeclaration> declared;
  if (!is_ptx) declared = declared_parameters(text.str(), file.program.string(), "", file.kernel);
  const auto executable = Executable::compile(ptx, file.kernel, TraceMode::none, "data");
  const std::vector<BoundArgument> bound = bind_arguments(file, executable->parameters(), declared);
  std::vector<KernelArgument> arguments;
  for (const BoundArgument& argument : bound) arguments.push_back(argument.argument);
  const auto found = oracle::differences(ptx, file.kernel, file.shape, arguments);
  EXPECT_TRUE(found.empty()) << fmt::format("{}", fmt::join(found, "\n"));
}

INSTANTIATE_TEST_SUITE_P(Data, OracleOnData, testing::ValuesIn(launch_files()),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace warpgrain::profiler
