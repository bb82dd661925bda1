#include <cstring>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

#include "profiler/cuda_frontend.hpp"
#include "profiler/launch_file.hpp"
#include "profiler/nvrtc.hpp"
#include "profiler/subprocess.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

using testing::HasSubstr;

const char* const scaling_kernel = R"(#include "factor.h"
template <class T> __global__ void scaled(T* out, const T* in) {
  extern __shared__ T tile[];
  const unsigned i = threadIdx.x;
  tile[i] = in[i];
  __syncthreads();
  if (i % 2 == 1)  // branch: odd
    out[i] = FACTOR * tile[blockDim.x - 1 - i] + OFFSET;
}
template __global__ void scaled<int>(int*, const int*);
)";

class CudaFrontend : public testing::Test {
 protected:
  CudaFrontend() {
    write_text(folder_.path() / "k.cu", scaling_kernel);
    write_text(folder_.path() / "factor.h", "#define FACTOR 3\n");
    write_text(folder_.path() / "k.sim",
               "k.cu scaled 32 1 1 32 1 1 <size=128 int fill=0> <size=128 int range=0:1:31> <size=128>");
  }

  LaunchFileResult profile(const std::string& build_options) const {
    std::ostringstream out;
    return profile_launch_file(read_launch_file(folder_.path() / "k.sim"), build_options, {}, out);
  }

  static bool has_compiler() {
    return !find_program("nvcc").empty() || std::filesystem::exists("/usr/local/cuda/bin/nvcc") ||
           compile_with_nvrtc("", "empty.cu", {}).has_value();
  }

  TemporaryFolder folder_;
};

TEST_F(CudaFrontend, ALaunchOfACuFileEndsInLinesAndBranchesOfTheSource) {
  if (!has_compiler()) GTEST_SKIP() << "neither nvcc nor NVRTC";
  const LaunchFileResult result = profile("-DOFFSET=1000 -arch=sm_80");
  for (int i = 0; i < 32; ++i) {
    int value = 0;
    std::memcpy(&value, result.buffers[0].bytes().data() + 4 * i, sizeof value);
    EXPECT_EQ(value, i % 2 == 1 ? 3 * (31 - i) + 1000 : 0);
  }
  const LaunchProfile& profile = result.profile;
  EXPECT_THAT(profile.compile_command, HasSubstr("-lineinfo -DOFFSET=1000 -arch=sm_80"));
  EXPECT_EQ(profile.counters.kernel, "scaled<int>");
  ASSERT_FALSE(profile.counters.lines.empty());
  EXPECT_EQ(profile.counters.lines.back().file, (folder_.path() / "k.cu").string());
  ASSERT_EQ(profile.counters.branches.size(), 1u);
  EXPECT_EQ(profile.counters.branches[0].label, "odd");
  EXPECT_EQ(profile.counters.totals.divergent_branches, 1u);
}

TEST_F(CudaFrontend, TheCompilersMessagesNameTheLine) {
  if (!has_compiler()) GTEST_SKIP() << "neither nvcc nor NVRTC";
  const std::string message = refusal([&] { profile(""); });
  EXPECT_THAT(message, HasSubstr("k.cu: it does not compile\n"));
  EXPECT_THAT(message, HasSubstr("k.cu(8): error: identifier \"OFFSET\" is undefined"));
}

TEST_F(CudaFrontend, NvrtcCompilesWhereThereIsNoNvcc) {
  const auto result = compile_with_nvrtc("extern \"C\" __global__ void k(int* a) { *a = N; }", "k.cu",
                                         {"-DN=5", "-arch=compute_80"});
  if (!result) GTEST_SKIP() << "no libnvrtc";
  EXPECT_THAT(result->version, testing::StartsWith("NVRTC "));
  EXPECT_THAT(result->ptx, HasSubstr(".entry k("));
  const auto broken = compile_with_nvrtc("__global__ void k(int* a) { *a = M; }", "k.cu", {});
  EXPECT_EQ(broken->ptx, "");
  EXPECT_THAT(broken->log, HasSubstr("k.cu(1): error"));
}

}  // namespace
}  // namespace warpgrain::profiler
