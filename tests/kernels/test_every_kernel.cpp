// Every kernel file stands on its own: it compiles with nothing but the headers it includes, in every
// precision.

#include <cstdlib>
#include <gtest/gtest.h>
#include <string>

#include "kernels/embedded_kernels.hpp"
#include "tests/paths.hpp"

namespace warpgrain {
namespace {

TEST(EveryKernel, CompilesAlone) {
  if (std::system("clang-15 --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no clang-15 here";
  const std::string folder = source_path("kernels/");
  int files = 0;
  for (const EmbeddedKernel& kernel : embedded_kernels()) {
    if (!kernel.path.ends_with(".cl")) continue;
    ++files;
    for (const char* precision : {"32", "64", "32 -D FIXED_POINT", "32 -D HALF_HISTORY"}) {
      // A law's caller and a caller's law are in other files, hence the two warnings left out.
      const std::string command =
          "clang-15 -x cl -cl-std=CL1.2 -target nvptx64 -Xclang -cl-ext=+cl_khr_int64_base_atomics "
          "-fsyntax-only -Wall -Wextra -Werror "
          "-Wno-unused-function -Wno-undefined-internal -Wno-unused-parameter -I " +
          folder + " -D REAL_BITS=" + precision + " " + folder + std::string(kernel.path);
      EXPECT_EQ(std::system(command.c_str()), 0) << command;
    }
  }
  EXPECT_GT(files, 0);
}

}  // namespace
}  // namespace warpgrain
