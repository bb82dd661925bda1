#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
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
  const std::string name = open_opencl_device({})->name();
  EXPECT_EQ(open_opencl_device(name.substr(1, 5))->name(), name);
  const std::string message = message_of([] { open_opencl_device("no such device"); });
  EXPECT_THAT(message, HasSubstr("--device: unknown device 'no such device'; valid: "));
  EXPECT_THAT(message, HasSubstr(name));
}

TEST(OpenclDevice, ThatMakesNoPtxSaysSo) {
  const auto device = open_opencl_device("portable computing language", {}, "never_made");
  const std::string message = message_of([&] {
    device->build(std::vector<SourceUnit>{{"kernel void k(global int* a) { a[0] = 1; }", ""}});
  });
  EXPECT_THAT(message, HasSubstr("--keep-ptx: "));
  EXPECT_THAT(message, HasSubstr(" makes no PTX; expected a device whose OpenCL compiler does"));
  EXPECT_FALSE(std::filesystem::exists("never_made"));
}

}  // namespace
}  // namespace warpgrain
