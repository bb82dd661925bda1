#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "profiler/launch_check.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Pointer = KernelParameter::Pointer;

TranslatedKernel kernel_of(std::vector<KernelParameter> parameters) {
  TranslatedKernel kernel;
  kernel.where = "k.ptx";
  kernel.graph.kernel = "k";
  kernel.parameters = std::move(parameters);
  return kernel;
}

TEST(LaunchCheck, Shapes) {
  TranslatedKernel kernel = kernel_of({});
  const auto refused = [&](const LaunchShape& shape) { return refusal([&] { check_shape(kernel, shape); }); };
  EXPECT_EQ(refused({{64, 8, 1}, {32, 8, 1}}), "");
  EXPECT_EQ(refused(line_of(100, 32)),
            "k.ptx: kernel 'k': global size 100 and local size 32 in dimension 0; expected a global size "
            "that the local size divides: only OpenCL C has smaller last work-groups");
  kernel.takes_smaller_groups = true;
  EXPECT_EQ(refused(line_of(100, 32)), "");
  EXPECT_THAT(refused(line_of(64, 0)), HasSubstr("local size 0"));
  EXPECT_THAT(refused({{64, 0, 1}, {32, 1, 1}}), HasSubstr("global size 0 and local size 1 in dimension 1"));
  EXPECT_THAT(refused({{64, 64, 64}, {64, 64, 64}}), HasSubstr("at most 1024 work-items"));
  EXPECT_THAT(refused({{std::uint64_t{1} << 40, 1, 1}, {1, 1, 1}}), HasSubstr("fewer than 2^32"));
  kernel.required_local_size = {64, 1, 1};
  EXPECT_THAT(refused(line_of(128, 32)), HasSubstr("64 x 1 x 1, which the kernel requires"));
}

TEST(LaunchCheck, Arguments) {
  const TranslatedKernel kernel =
      kernel_of({{"a", 8, 8, Pointer::global}, {"n", 4, 4, Pointer::none}, {"s", 8, 8, Pointer::shared}});
  std::vector<int> memory(4);
  const auto refused = [&](const std::vector<KernelArgument>& arguments) {
    return refusal([&] { check_arguments(kernel, arguments); });
  };
  EXPECT_EQ(refused({buffer_of(memory), scalar_of(3), KernelArgument::local(16)}), "");
  EXPECT_EQ(refused({buffer_of(memory)}), "k.ptx: kernel 'k': 1 arguments; expected 3");
  EXPECT_EQ(refused({scalar_of(3), scalar_of(3), KernelArgument::local(16)}),
            "k.ptx: kernel 'k', argument 0 (a): a scalar; expected a buffer");
  EXPECT_THAT(refused({buffer_of(memory), scalar_of(3.0), KernelArgument::local(16)}),
              HasSubstr("argument 1 (n): a scalar of 8 bytes; expected 4 bytes"));
  EXPECT_THAT(refused({buffer_of(memory), buffer_of(memory), KernelArgument::local(16)}),
              HasSubstr("a buffer; expected a scalar of 4 bytes"));
  EXPECT_THAT(refused({buffer_of(memory), scalar_of(3), buffer_of(memory)}),
              HasSubstr("(s): a buffer; expected local memory"));
}

TEST(LaunchCheck, LocalArgumentsLieBehindStaticSharedMemory) {
  TranslatedKernel kernel = kernel_of({});
  kernel.graph.shared_bytes = 100;
  std::vector<int> memory(4);
  const std::vector<KernelArgument> arguments{KernelArgument::local(4), buffer_of(memory),
                                              KernelArgument::local(200)};
  EXPECT_THAT(shared_offsets(kernel, arguments), ElementsAre(128, 132, 256, 456));
}

}  // namespace
}  // namespace warpgrain::profiler
