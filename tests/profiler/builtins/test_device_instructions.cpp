// What a device issues: native functions are one approximate instruction (with what their definition needs
// around it), and the powers of e, 2 and 10 are built on one.

#include <gtest/gtest.h>
#include <string>

#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler::builtins {
namespace {

// Special-function operations in `y = call`, of floats x and y.
int special_operations(const std::string& call) {
  const auto executable = compile_kernel(
      "kernel void k(global float* r, float x, float y) { r[0] = " + call + "; }", "k", TraceMode::none);
  int operations = 0;
  for (const auto& block : executable->graph().blocks)
    for (const auto& instruction : block.instructions) operations += instruction.sfu_operations;
  return operations;
}

TEST(DeviceInstructions, NativeFunctionsAreOneSpecialOperation) {
  for (const char* name : {"native_sin", "native_cos", "native_exp", "native_exp2", "native_exp10",
                           "native_log", "native_log2", "native_log10", "native_recip", "native_sqrt",
                           "native_rsqrt", "half_exp2", "exp", "exp2", "exp10", "sqrt", "rsqrt"})
    EXPECT_EQ(special_operations(std::string(name) + "(x)"), 1) << name;
  EXPECT_EQ(special_operations("native_divide(x, y)"), 1);
  EXPECT_EQ(special_operations("x / y"), 1);
  EXPECT_EQ(special_operations("native_powr(x, y)"), 2);
  EXPECT_EQ(special_operations("native_tan(x)"), 3);
}

TEST(DeviceInstructions, ConversionsWithARoundingModeAreOneInstruction) {
  const auto count = [](const std::string& call) {
    const std::string ptx =
        compile_opencl("kernel void k(global int* r, float x) { r[0] = " + call + "; }", "kernel.cl").ptx;
    int conversions = 0;
    for (std::size_t at = ptx.find("cvt."); at != std::string::npos; at = ptx.find("cvt.", at + 1))
      ++conversions;
    return conversions;
  };
  for (const char* suffix : {"", "_rte", "_rtz", "_rtp", "_rtn", "_sat", "_sat_rte", "_sat_rtp"})
    EXPECT_EQ(count("convert_int" + std::string(suffix) + "(x)"), 1) << suffix;
}

}  // namespace
}  // namespace warpgrain::profiler::builtins
