#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "random_bed.hpp"
#include "variants/opencl_device.hpp"

namespace warpgrain {
namespace {

using testing::HasSubstr;

std::string message_of(auto&& call) {
  try {
    call();
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(OpenclDevice, IsFoundByPartOfItsName) {
  const std::string name = open_opencl_device({}, false)->name();
  EXPECT_EQ(open_opencl_device(name.substr(1, 5), false)->name(), name);
  const std::string message = message_of([] { open_opencl_device("no such device", false); });
  EXPECT_THAT(message, HasSubstr("--device: unknown device 'no such device'; valid: "));
  EXPECT_THAT(message, HasSubstr(name));
}

TEST(OpenclDevice, PassesTheCompilersMessageOnWithFileAndLine) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "broken_kernels";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "find_cells.cl")
      << "#include \"prelude.h\"\nKERNEL void clear_cells(int x) {\n  x = 1 +;\n}\n";
  const Scene bed = random_bed({.n_particles = 10});
  const std::string message = message_of([&] {
    backend("opencl").create(bed, Variant(), {.device = {}, .threads = 0, .kernel_folder = folder.string()});
  });
  EXPECT_THAT(message, HasSubstr("kernels: do not compile"));
  EXPECT_THAT(message, HasSubstr("find_cells.cl:3:"));
  EXPECT_THAT(message, HasSubstr("expected expression"));

  std::ofstream(folder / "find_cells.cl")
      << "#include \"prelude.h\"\nKERNEL void clear_cels(GLOBAL int* x) { *x = 1; }\n";
  EXPECT_THAT(message_of([&] {
                backend("opencl").create(bed, Variant(),
                                         {.device = {}, .threads = 0, .kernel_folder = folder.string()});
              }),
              HasSubstr("kernels: no kernel 'clear_cells'; expected "));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace warpgrain
