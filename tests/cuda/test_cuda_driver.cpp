// The CUDA driver's wrapper and what stands on it, on a driver of this test's own (driver/libcuda.cpp) whose
// device is the simulator.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../cli/command_fixture.hpp"
#include "../cli/detector_calls.hpp"
#include "core/error.hpp"
#include "reports/benchmark_json.hpp"
#include "reports/measured_report.hpp"
#include "variants/cuda_program.hpp"

namespace warpgrain::cli {
namespace {

using testing::HasSubstr;

class Cuda : public CommandTest {
 protected:
  // Four buffers, scalars of several sizes and three dimensions.
  std::string write_launch() {
    write("k.cl",
          "kernel void weigh(constant float* in, float weight, global int* out, uchar shift, ulong n) {\n"
          "  const size_t i = (get_global_id(2) * get_global_size(1) + get_global_id(1)) * "
          "get_global_size(0) +\n"
          "                   get_global_id(0);\n"
          "  if (i < n) out[i] = (int)(in[i] * weight) << shift;\n}\n");
    return write("k.sim",
                 "k.cl\nweigh\n16 4 2\n8 2 1\n<size=512 float range=0:1:127>\n<size=4 float> 2.5\n"
                 "<size=512 int fill=7 dump>\n<size=1 uchar> 1\n<size=8 ulong> 100\n");
  }
};

TEST_F(Cuda, OpensTheDriverOfTheTest) {
  ASSERT_EQ(cuda_lacks(), "");
  const CudaDevice device("test");
  EXPECT_EQ(device.name(), "Test device");
  EXPECT_EQ(device.architecture(), "sm_90");
  EXPECT_THAT(device.driver(), HasSubstr("CUDA 13.0"));
  EXPECT_THROW(CudaDevice("h100"), InputError);
}

TEST_F(Cuda, MeasureGivesTimesDumpsAndAgreement) {
  ASSERT_EQ(call({"measure", write_launch(), "--repeats", "5", "--check", "--json", path("m.json")}), 0)
      << err_;
  EXPECT_THAT(out_, HasSubstr("out[2] = 10\n"));
  EXPECT_THAT(out_, HasSubstr("out[100] = 7\n"));
  EXPECT_THAT(out_, HasSubstr("'out': the simulator's 128 elements"));
  const reports::MeasuredReport measured = reports::read_measured(path("m.json"));
  EXPECT_EQ(measured.device.name, "Test device");
  ASSERT_EQ(measured.kernels.size(), 1u);
  EXPECT_EQ(measured.kernels[0].kernel, "weigh");
  EXPECT_EQ(measured.kernels[0].seconds.size(), 5u);
  EXPECT_EQ(measured.kernels[0].code->registers, 20u);
  ASSERT_EQ(measured.kernels[0].agreement.size(), 2u);
  EXPECT_EQ(measured.kernels[0].agreement[1].differing, 0u);
  EXPECT_EQ(reports::measured_json(measured), read("m.json"));
}

// What Ctrl-C leaves has fewer readings and no agreement.
TEST_F(Cuda, MeasureTakesTheReadingsThatAreLeft) {
  const std::vector<std::string> words{"measure", write_launch(), "--repeats",   "5",
                                       "--check", "--json",       path("m.json")};
  std::vector<std::string> again = words;
  again.push_back("--resume");
  ASSERT_EQ(call(words), 0) << err_;
  reports::MeasuredReport partial = reports::read_measured(path("m.json"));
  partial.kernels[0].seconds = {1.5, 2.5};
  partial.kernels[0].agreement.clear();
  write("m.json", reports::measured_json(partial));
  ASSERT_EQ(call(again), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("out[2] = 10\n"));
  const reports::MeasuredReport resumed = reports::read_measured(path("m.json"));
  ASSERT_EQ(resumed.kernels[0].seconds.size(), 5u);
  EXPECT_EQ(resumed.kernels[0].seconds[1], 2.5);
  EXPECT_EQ(resumed.kernels[0].agreement.size(), 2u);
}

TEST_F(Cuda, ExportedLaunchesRunAlike) {
  ASSERT_EQ(call({"profile", write_launch(), "--export", path("out")}), 0) << err_;
  const std::string simulated = out_.substr(0, out_.find("\n\n", 10));
  ASSERT_EQ(call({"measure", path("out/k.sim"), "--quiet"}), 0) << err_;
  EXPECT_EQ(std::count(simulated.begin(), simulated.end(), '='), 128);
  EXPECT_EQ(std::count(out_.begin(), out_.end(), '='), 128);
  EXPECT_THAT(out_, HasSubstr("[2] = 10\n"));
}

TEST_F(Cuda, KeepsWhatItLoads) {
  ASSERT_EQ(call({"measure", write_launch(), "--repeats", "1", "--quiet", "--keep", path("kept")}), 0)
      << err_;
  EXPECT_THAT(read("kept/k.ptx"), HasSubstr(".entry weigh("));
  EXPECT_THAT(read("kept/k.ptx"), testing::Not(HasSubstr("texmode_independent")));
}

// Both run the same PTX in the simulator.
TEST_F(Cuda, BackEndGivesTheSimulatorsState) {
  for (const char* backend : {"cuda", "simt"})
    ASSERT_EQ(call({"run", "--scene", "head_on", "--steps", "40", "--backend", backend, "--state",
                    path(std::string(backend) + ".csv"), "--json", path("run.json"), "--quiet"}),
              0)
        << err_;
  EXPECT_EQ(read("cuda.csv"), read("simt.csv"));
  EXPECT_NE(read("cuda.csv"), "");
}

// As on every other back end: tests/cli/test_detectors.cpp.
TEST_F(Cuda, DetectorsFire) {
  for (const DetectorCall& bad : detector_calls()) {
    EXPECT_EQ(call({"run", "--scene", write("scene.json", bad.scene.text()), "--backend", "cuda", "--steps",
                    std::to_string(bad.steps), "--sample-every", "1", "--quiet"}),
              bad.status)
        << bad.what;
    for (const std::string& words : bad.says) EXPECT_THAT(err_, HasSubstr(words)) << bad.what;
  }
}

TEST_F(Cuda, MeasureTimesAStepAndItsKernels) {
  ASSERT_EQ(
      call({"measure", "--scene", "head_on", "--backend", "cuda", "--at-step", "4", "--repeats", "3",
            "--warm-up", "1", "--steps", "2", "--json", path("m.json"), "--benchmark-json", path("b.json")}),
      0)
      << err_;
  EXPECT_THAT(out_, HasSubstr("million particle-steps/s"));
  const reports::MeasuredReport measured = reports::read_measured(path("m.json"));
  EXPECT_EQ(measured.scene, "head_on");
  EXPECT_THAT(measured.device.driver, HasSubstr("CUDA 13.0"));
  ASSERT_TRUE(measured.step);
  EXPECT_EQ(measured.step->steps, 2u);
  EXPECT_EQ(measured.step->seconds.size(), 3u);
  const auto sort =
      std::ranges::find(measured.kernels, "sort_blocks", &reports::MeasuredReport::Kernel::kernel);
  ASSERT_NE(sort, measured.kernels.end());
  EXPECT_EQ(sort->calls, 1u);
  EXPECT_EQ(sort->seconds.size(), 3u);
  const auto times = reports::read_benchmark_json(path("b.json"));
  ASSERT_EQ(times.size(), measured.kernels.size() + 1);
  EXPECT_EQ(times[0].name, "step");
  EXPECT_NEAR(times[0].seconds[1], measured.step->seconds[1], 1e-12);
}

// A profiler slows what it sees, so that nothing is timed.
TEST_F(Cuda, MarksAStepForProfilers) {
  ASSERT_EQ(call({"measure", "--scene", "head_on", "--backend", "cuda", "--mark", "--json", path("m.json")}),
            0)
      << err_;
  const reports::MeasuredReport measured = reports::read_measured(path("m.json"));
  EXPECT_FALSE(measured.step);
  EXPECT_TRUE(measured.kernels.empty());
}

TEST_F(Cuda, RefusesInOneLine) {
  const std::string launch = write_launch();
  EXPECT_EQ(call({"measure", launch, "--assembler", "nvcc"}), 2);
  EXPECT_THAT(err_, HasSubstr("--assembler: unknown assembler 'nvcc'; valid: driver, ptxas"));
  EXPECT_EQ(call({"measure", launch, "--device", "tpu"}), 2);
  EXPECT_THAT(err_, HasSubstr("valid: Test device"));
  EXPECT_EQ(call({"measure", "--scene", "head_on", "--counters"}), 2);
  EXPECT_THAT(err_, HasSubstr("--backend cuda"));
  EXPECT_EQ(call({"measure", launch, "--scene", "head_on"}), 2);
  EXPECT_EQ(call({"measure", launch, "--repeats", "0"}), 2);
  EXPECT_EQ(error_lines(), 1u);
}

TEST(CudaProgram, TakesAwayWhatOnlyOpenclKnows) {
  EXPECT_EQ(ptx_for_cuda(".target sm_70, texmode_independent\n.param .u64 .ptr .shared .align 4 a,\n"
                         ".param .u64 .ptr .global .align 4 b\nmov.u32 %r1, %envreg3;\n",
                         "test"),
            ".target sm_70\n.param .u64 a,\n.param .u64 .ptr .global .align 4 b\nmov.u32 %r1, 0;\n");
  // A buffer of constants is a buffer; beside variables in constant memory nobody could tell their loads
  // apart.
  const std::string constants = ".param .u64 .ptr .const .align 4 c\nld.const.f32 %f1, [%rd1];\n";
  EXPECT_EQ(ptx_for_cuda(constants, "test"),
            ".param .u64 .ptr .global .align 4 c\nld.global.f32 %f1, [%rd1];\n");
  EXPECT_THROW(ptx_for_cuda(".const .align 4 .b8 table[4];\n" + constants, "test"), InputError);
}

TEST(CudaModule, ErrorsCarryTheDriversNameAndLog) {
  const CudaDevice device("");
  try {
    CudaModule(device, "no PTX", "k.sim");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "k.sim on Test device: cuModuleLoadDataEx failed with CUDA_ERROR_INVALID_IMAGE (as the test "
                 "has it)\ntest driver: not PTX for CUDA");
  }
}

}  // namespace
}  // namespace warpgrain::cli
