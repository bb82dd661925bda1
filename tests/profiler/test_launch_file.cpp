#include <cstdlib>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdexcept>

#include "core/error.hpp"
#include "profiler/launch_file.hpp"
#include "tests/paths.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::profiler {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class LaunchFiles : public testing::Test {
 protected:
  LaunchFile read(const std::string& text) {
    std::ofstream(folder_ / "x.sim") << text;
    return read_launch_file(folder_ / "x.sim");
  }
  std::string error_of(const std::string& text) {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  TemporaryFolder folder_;
};

TEST_F(LaunchFiles, ReadsEverything) {
  const LaunchFile file = read(R"(# a comment
k.cl  my_kernel
64 2 1   # global
32 1 1
<size=16 float range=1:0.5:2.5 dump ro>
<size=8 uint4 hex>
10 ff   # two
20<size=4>7
<null>
<size=64 file=data/in.bin wo>
<size=64 noinit>
)");
  EXPECT_EQ(file.program, folder_ / "k.cl");
  EXPECT_EQ(file.kernel, "my_kernel");
  EXPECT_THAT(file.shape.global_size, ElementsAre(64, 2, 1));
  EXPECT_THAT(file.shape.local_size, ElementsAre(32, 1, 1));
  ASSERT_EQ(file.arguments.size(), 6U);
  const auto& a = file.arguments;
  EXPECT_EQ(a[0].size, 16U);
  EXPECT_EQ(a[0].line, 5);
  EXPECT_EQ(a[0].type, ElementType::f32);
  EXPECT_EQ(a[0].range, "1:0.5:2.5");
  EXPECT_TRUE(a[0].dump && a[0].read_only);
  EXPECT_TRUE(a[1].hex && !a[1].dump);
  EXPECT_EQ(a[1].type, ElementType::u32);
  ASSERT_EQ(a[1].values.size(), 3U);
  EXPECT_EQ(a[1].values[2].text, "20");
  EXPECT_EQ(a[1].values[2].line, 8);
  ASSERT_EQ(a[2].values.size(), 1U);
  EXPECT_EQ(a[2].type, std::nullopt);
  EXPECT_TRUE(a[3].is_null);
  EXPECT_EQ(a[4].file, folder_ / "data/in.bin");
  EXPECT_TRUE(a[5].no_init && a[4].write_only);
}

TEST_F(LaunchFiles, WrittenFilesAreReadAlike) {
  const std::string text =
      "k.cl\nmy_kernel\n64 2 1\n32 1 1\n<size=16 float range=1:0.5:2.5 ro dump>\n<size=8 uint hex> 10 ff\n"
      "<size=4> 7\n<null>\n<size=64 file=in.bin wo>\n<size=64 noinit>\n<size=8 short fill=-3>\n";
  LaunchFile file = read(text);
  file.path = folder_ / "y.sim";
  file.program = "k.cl";
  file.arguments[4].file = "in.bin";
  write_launch_file(file);
  std::ifstream in(file.path);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), text);
  file.path = folder_ / "nowhere/y.sim";
  EXPECT_THROW(write_launch_file(file), InputError);
}

TEST_F(LaunchFiles, TheProgramMayStandRelativeToTheWorkingDirectory) {
  const std::string here = std::filesystem::relative(source_path("")).string() + "/CMakeLists.txt";
  EXPECT_EQ(read(here + " k 1 1 1 1 1 1").program, here);
}

TEST_F(LaunchFiles, TakesTheBuildOptionsBesideTheProgram) {
  EXPECT_EQ(read("k.cl k 1 1 1 1 1 1").build_options, "");
  std::ofstream(folder_ / "k.cl.options") << "-DX='a b' -cl-mad-enable\n";
  EXPECT_EQ(read("k.cl k 1 1 1 1 1 1").build_options, "-DX='a b' -cl-mad-enable");
}

TEST_F(LaunchFiles, ErrorsNameFileLineAndWhatWasExpected) {
  const std::string head = "k.cl k\n64 1 1\n32 1 1\n";
  EXPECT_THAT(error_of(""), HasSubstr("expected the program's file name"));
  EXPECT_THAT(error_of("k.cl\n"), HasSubstr("expected the kernel's name"));
  EXPECT_THAT(error_of("k.cl k\n64 x 1\n"),
              HasSubstr("x.sim:2: 'x'; expected a global size, three numbers above 0"));
  EXPECT_THAT(error_of("k.cl k\n64 1 1\n-32 1 1\n"), HasSubstr("x.sim:3: '-32'"));
  EXPECT_THAT(error_of("k.cl k\n64 1 1\n0 1 1\n"), HasSubstr("x.sim:3: '0'"));
  EXPECT_THAT(error_of(head + "size=4\n"), HasSubstr("x.sim:4: 'size=4'; expected an argument"));
  EXPECT_THAT(error_of(head + "<size=4\n7\n"), HasSubstr("x.sim:4"));
  EXPECT_THAT(error_of(head + "<size=x>\n"), HasSubstr("'size=x'; expected a number of bytes"));
  EXPECT_THAT(error_of(head + "<size=>\n"), HasSubstr("'size='"));
  EXPECT_THAT(error_of(head + "<fill=3>\n"), HasSubstr("expected size=BYTES"));
  EXPECT_THAT(error_of(head + "<size=4 flaot>\n"), HasSubstr("unknown word 'flaot'"));
  EXPECT_THAT(error_of(head + "<size=4 float int>\n"), HasSubstr("a second type, 'int'"));
  EXPECT_THAT(error_of(head + "<size=4 fill=1 noinit>\n"), HasSubstr("several sources"));
  EXPECT_THAT(error_of(head + "<size=4 fill=1 ro wo>\n"), HasSubstr("'ro' and 'wo'"));
  EXPECT_THAT(error_of(head + "<size=4 null>\n"), HasSubstr("'null' beside"));
  try {
    read_launch_file(folder_ / "nowhere.sim");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("nowhere.sim: cannot be read"));
  }
}

}  // namespace
}  // namespace warpgrain::profiler
