// The simulator against an independent interpreter that issues every instruction for all active lanes of a
// warp at once (tests/profiler/oracle): every kernel of the test data, every policy, widths 8 and 32.

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "profiler/launch_arguments.hpp"
#include "profiler/launch_file.hpp"
#include "profiler/opencl_frontend.hpp"
#include "profiler/ptx/parser.hpp"
#include "tests/paths.hpp"
#include "tests/profiler/oracle/comparison.hpp"
#include "tests/profiler/oracle/lockstep.hpp"

namespace warpgrain::profiler {
namespace {

const std::filesystem::path oracle_files = source_path("tests/profiler/data");

// Paths below the folder of the data, without ".sim".
std::vector<std::string> launch_files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(oracle_files))
    if (entry.path().extension() == ".sim")
      names.push_back(std::filesystem::relative(entry.path(), oracle_files).replace_extension().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void expect_no_differences(const std::string& ptx, const std::string& kernel, const LaunchShape& shape,
                           const std::vector<KernelArgument>& arguments) {
  try {
    const auto found = oracle::differences(ptx, kernel, shape, arguments);
    EXPECT_TRUE(found.empty()) << fmt::format("{}", fmt::join(found, "\n"));
  } catch (const oracle::UnknownInstruction& unknown) {
    GTEST_SKIP() << unknown.what();
  }
}

class OracleOnData : public testing::TestWithParam<std::string> {};

TEST_P(OracleOnData, AgreesInEveryCount) {
  const LaunchFile file = read_launch_file(oracle_files / (GetParam() + ".sim"));
  const std::string text = text_of(file.program), name = file.program.string();
  const std::string ptx = compile_opencl(text, name).ptx;
  const auto executable = Executable::compile(ptx, file.kernel, TraceMode::none, name);
  const std::vector<BoundArgument> bound =
      bind_arguments(file, executable->parameters(), declared_parameters(text, name, "", file.kernel));
  std::vector<KernelArgument> arguments;
  for (const BoundArgument& argument : bound) arguments.push_back(argument.argument);
  expect_no_differences(ptx, file.kernel, file.shape, arguments);
}

INSTANTIATE_TEST_SUITE_P(Data, OracleOnData, testing::ValuesIn(launch_files()), [](const auto& parameter) {
  std::string name = parameter.param;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
});

// What nvcc writes: a function that is called, addresses of shared memory in 32 bits, a struct by value.
TEST(Oracle, AgreesOnPtxFromNvcc) {
  DeviceBuffer in(128 * 4), out(129 * 4);
  for (std::uint32_t i = 0; i < 128; ++i) {
    const std::uint32_t word = i * i + 1;
    std::memcpy(in.bytes().data() + 4 * i, &word, sizeof word);
  }
  const struct {
    std::uint32_t most;
    float scale;
  } limits{30, 1.5f};
  expect_no_differences(text_of(oracle_files / "collatz.ptx"), "collatz", {{128, 1, 1}, {64, 1, 1}},
                        {KernelArgument::buffer(out.bytes()), KernelArgument::buffer(in.bytes()),
                         KernelArgument::scalar(std::as_bytes(std::span(&limits, 1)))});
}

// Lanes leave a loop one after another. A stack of post-dominators lets each run its iteration's rest alone,
// and hardware does not: `ipdom` must show what `loop_postdom` does not.
TEST(Oracle, KnowsWhatPartsThePolicies) {
  const std::string ptx = compile_opencl(R"(
kernel void k(global uint* out) {
  uint i = get_global_id(0), x = i;
  for (uint n = 0; n < 64; ++n) {
    if ((x & 3) == 0) { x += 5; if (x % 7 == 0) continue; x ^= n; }
    if (x > 200 + i) break;
    x = x * 3 + n;
  }
  out[i] = x;
})",
                                         "k.cl")
                              .ptx;
  const ptx::Module module = ptx::parse(ptx, "k.cl");
  const oracle::Program program = oracle::decode(module, *module.find_entry("k"));
  const oracle::Flow flow(program);
  EXPECT_EQ(flow.loops().size(), 1u);
  std::vector<std::uint64_t> issued;
  for (const char* policy : {"ipdom", "loop_postdom", "min_pc"}) {
    DeviceBuffer out(64 * 4);
    const std::vector<KernelArgument> arguments{KernelArgument::buffer(out.bytes())};
    issued.push_back(oracle::run_lockstep(program, flow, oracle::Policy(flow, policy), 32,
                                          {{64, 1, 1}, {32, 1, 1}}, arguments)
                         .issued);
  }
  EXPECT_GT(issued[0], issued[1]);
  EXPECT_GE(issued[1], issued[2]);
}

}  // namespace
}  // namespace warpgrain::profiler
