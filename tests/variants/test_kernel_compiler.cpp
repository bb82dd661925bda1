// Names and options of the kernels' compilers; what they make is in test_conformance.cpp.

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "variants/kernel_compiler.hpp"

namespace warpgrain {
namespace {

TEST(KernelCompiler, NamesAndOptions) {
  EXPECT_EQ(kernel_compiler("cuda", "--compiler"), KernelCompiler::cuda);
  EXPECT_THROW(kernel_compiler("gcc", "--compiler"), InputError);
  EXPECT_EQ(cuda_build_options("-cl-std=CL1.2 -D A=1 -DB"),
            "--std=c++17 --prec-div=false --prec-sqrt=false -D A=1 -DB");
  EXPECT_EQ(cuda_build_options("-cl-fast-relaxed-math"), "--std=c++17 --use_fast_math");
  EXPECT_THROW(cuda_build_options("-cl-opt-disable"), InputError);
}

}  // namespace
}  // namespace warpgrain
