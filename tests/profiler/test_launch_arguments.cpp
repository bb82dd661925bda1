#include <cstring>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>

#include "core/error.hpp"
#include "profiler/launch_arguments.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::profiler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr KernelParameter::Pointer none = KernelParameter::Pointer::none,
                                   global = KernelParameter::Pointer::global,
                                   shared = KernelParameter::Pointer::shared;

// Binds one argument to one parameter.
class LaunchArguments : public testing::Test {
 protected:
  LaunchArguments() {
    file_.path = "x.sim";
    file_.kernel = "k";
    file_.arguments.resize(1);
    file_.arguments[0].line = 5;
    file_.arguments[0].size = 16;
    given().type = ElementType::i32;
  }
  LaunchFileArgument& given() { return file_.arguments[0]; }
  void give_values(const std::vector<std::string>& values) {
    for (const std::string& value : values) given().values.push_back({value, 6});
  }

  BoundArgument bind() {
    std::vector<BoundArgument> bound = bind_arguments(file_, std::span(&parameter_, 1), declared_);
    return std::move(bound.at(0));
  }
  std::string error() {
    try {
      bind();
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
  template <typename T = std::int32_t>
  std::vector<T> values(std::span<const std::byte> data) {
    std::vector<T> result(data.size() / sizeof(T));
    std::memcpy(result.data(), data.data(), data.size());
    return result;
  }

  LaunchFile file_;
  KernelParameter parameter_{"k_param_0", 8, 8, global};
  std::vector<ParameterDeclaration> declared_{{"a", "int*"}};
};

TEST_F(LaunchArguments, BuffersAreFilledAndAligned) {
  give_values({"1", "-2", "3", "4"});
  const BoundArgument bound = bind();
  EXPECT_EQ(bound.name, "a");
  EXPECT_EQ(bound.argument.kind, KernelArgument::Kind::buffer);
  EXPECT_EQ(bound.argument.memory.data(), bound.buffer.bytes().data());
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(bound.argument.memory.data()) % 256, 0U);
  EXPECT_THAT(values(bound.buffer.bytes()), ElementsAre(1, -2, 3, 4));
}

TEST_F(LaunchArguments, FillRangeNoInitAndNull) {
  given().fill = "7";
  EXPECT_THAT(values(bind().buffer.bytes()), ElementsAre(7, 7, 7, 7));
  given().fill.clear();
  given().range = "10:-5:-5";
  EXPECT_THAT(values(bind().buffer.bytes()), ElementsAre(10, 5, 0, -5));
  given().range.clear();
  given().no_init = true;
  EXPECT_THAT(values(bind().buffer.bytes()), ElementsAre(0, 0, 0, 0));
  given().no_init = false;
  given().is_null = true;
  given().size = 0;
  EXPECT_TRUE(bind().argument.memory.empty());
}

TEST_F(LaunchArguments, FileBytes) {
  const warpgrain::TemporaryFolder folder;
  const std::string path = (folder / "launch_arguments.bin").string();
  std::ofstream(path, std::ios::binary).write("\1\0\0\0\2\0\0\0\3\0\0\0\4\0\0\0", 16);
  given().file = path;
  EXPECT_THAT(values(bind().buffer.bytes()), ElementsAre(1, 2, 3, 4));
  given().size = 20;
  EXPECT_THAT(error(), HasSubstr("launch_arguments.bin' has 16 bytes; expected 20 bytes"));
  std::filesystem::remove(path);
  EXPECT_THAT(error(), HasSubstr("x.sim:5: argument 0 'a': "));
}

TEST_F(LaunchArguments, TheTypeComesFromTheFileElseFromTheSource) {
  give_values({"1", "2"});
  given().type = ElementType::f64;
  EXPECT_THAT(values<double>(bind().buffer.bytes()), ElementsAre(1, 2));
  given().type.reset();
  declared_[0].type = "long*";
  EXPECT_THAT(values<std::int64_t>(bind().buffer.bytes()), ElementsAre(1, 2));
  declared_[0].type = "struct P*";
  EXPECT_THAT(error(), HasSubstr("values for the type 'struct P*'; expected a type (char, "));
  declared_.clear();
  EXPECT_THAT(error(), HasSubstr("argument 0 'k_param_0': values without a type"));
}

TEST_F(LaunchArguments, ScalarsAndLocalMemory) {
  parameter_ = {"k_param_0", 16, 16, none};
  declared_[0].type = "int4";
  give_values({"1", "2", "3", "4"});
  EXPECT_THAT(values(bind().argument.value), ElementsAre(1, 2, 3, 4));
  given().size = 8;
  EXPECT_THAT(error(), HasSubstr("size=8; expected size=16, as the kernel declares it"));
  given().size = 16;
  given().dump = true;
  EXPECT_THAT(error(), HasSubstr("expected a buffer parameter"));
  given().dump = false;
  parameter_.pointer = shared;
  EXPECT_THAT(error(), HasSubstr("data for local memory; expected a size alone"));
  given().values.clear();
  EXPECT_EQ(bind().argument.kind, KernelArgument::Kind::local);
  EXPECT_EQ(bind().argument.local_bytes, 16U);
}

TEST_F(LaunchArguments, PtxWithoutPointerAttributesTakesBuffersBySizeAndFlags) {
  parameter_.pointer = none;
  declared_.clear();
  given().fill = "7";
  EXPECT_EQ(bind().argument.kind, KernelArgument::Kind::buffer);
  given().size = 8;
  EXPECT_EQ(bind().argument.kind, KernelArgument::Kind::scalar);
  given().dump = true;
  EXPECT_EQ(bind().argument.kind, KernelArgument::Kind::buffer);
}

TEST_F(LaunchArguments, WhatDoesNotFitIsNamed) {
  give_values({"1", "2", "3"});
  EXPECT_THAT(error(), HasSubstr("x.sim:5: argument 0 'a': 3 values; expected 4 of type int"));
  give_values({"x"});
  EXPECT_THAT(error(), HasSubstr("x.sim:6: argument 0 'a': 'x'; expected a value of type int"));
  given().size = 15;
  EXPECT_THAT(error(), HasSubstr("size=15; expected a multiple of 4, the size of int"));
  given().size = 16;
  given().range = "1:2";
  EXPECT_THAT(error(), HasSubstr("'range=1:2'; expected range=BEGIN:STEP:END"));
  given().range = "1:1:9";
  EXPECT_THAT(error(), HasSubstr("'range=1:1:9'; expected steps that reach the end after 4 values"));
  file_.arguments.push_back(file_.arguments[0]);
  file_.arguments[1].line = 9;
  EXPECT_THAT(error(), HasSubstr("x.sim:9: 2 arguments for kernel 'k'; expected 1: a"));
  file_.arguments.clear();
  EXPECT_THAT(error(), HasSubstr("0 arguments for kernel 'k'; expected 1: a"));
}

TEST_F(LaunchArguments, DumpsWhatTheFileAsksFor) {
  give_values({"1", "2", "3", "255"});
  given().hex = true;
  given().size = 8;
  given().values.resize(2);
  std::vector<BoundArgument> bound = bind_arguments(file_, std::span(&parameter_, 1), declared_);
  std::ostringstream out;
  dump_arguments(file_, bound, out);
  EXPECT_EQ(out.str(), "");
  given().dump = true;
  dump_arguments(file_, bound, out);
  EXPECT_EQ(out.str(), "\nArgument 'a': 8 bytes\n  a[0] = 0x00000001\n  a[1] = 0x00000002\n\n");
}

}  // namespace
}  // namespace warpgrain::profiler
