// What a user who writes kernels is told, whatever compiles them.

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "random_bed.hpp"
#include "tests/temporary_folder.hpp"
#include "variants/backend.hpp"

namespace warpgrain {
namespace {

using testing::HasSubstr;

class BrokenKernels : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (const std::string lack = backend(GetParam()).lacks(); !lack.empty()) GTEST_SKIP() << lack;
  }
  std::string message_with(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    BackendOptions options;
    options.kernel_folder = folder_.path().string();
    try {
      backend(GetParam())
          .create(random_bed({.n_particles = 10}), Variant::parse(Variant().name() + "/model=full"), options);
    } catch (const InputError& e) {
      return e.what();
    }
    return "accepted";
  }

  TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(EveryCompiler, BrokenKernels, testing::Values("opencl", "simt"),
                         [](const auto& name) { return std::string(name.param); });

TEST_P(BrokenKernels, AreAnsweredWithTheCompilersMessage) {
  const std::string message = message_with(
      "find_cells.cl", "#include \"prelude.h\"\nKERNEL void clear_cells(int x) {\n  x = 1 +;\n}\n");
  EXPECT_THAT(message, HasSubstr("find_cells.cl:3:"));
  EXPECT_THAT(message, HasSubstr("expected expression"));
}

TEST_P(BrokenKernels, AreAnsweredWithTheKernelsThatAreThere) {
  const std::string message = message_with(
      "find_cells.cl", "#include \"prelude.h\"\nKERNEL void clear_cels(GLOBAL int* x) { *x = 1; }\n");
  EXPECT_THAT(message, HasSubstr("clear_cells"));
  EXPECT_THAT(message, HasSubstr("clear_cels"));
  EXPECT_THAT(message, HasSubstr("map_particles"));
}

}  // namespace
}  // namespace warpgrain
