// Damaged launch files: whatever is cut off or changed, the answer is a launch or one line that names the
// file.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <sstream>
#include <stdexcept>

#include "core/error.hpp"
#include "profiler/launch_arguments.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::profiler {
namespace {

constexpr std::uint32_t fuzz_seed = 20240603;

class DamagedLaunchFiles : public testing::Test {
 protected:
  DamagedLaunchFiles() { std::ofstream(folder_ / "six.bin") << "sixsix"; }

  // Reads the text and binds its arguments to the parameters of a kernel that the undamaged text is for.
  void expect_answer(const std::string& text) {
    std::ofstream(folder_ / "x.sim", std::ios::binary) << text;
    try {
      const LaunchFile file = read_launch_file(folder_ / "x.sim");
      // A damaged size may ask for more memory than there is; that is the machine's answer, not the parser's.
      for (const LaunchFileArgument& argument : file.arguments)
        if (argument.size > (std::size_t{1} << 20)) return;
      bind_arguments(file, parameters_, declared_);
      ++n_accepted_;
    } catch (const InputError& error) {
      const std::string_view message = error.what();
      EXPECT_NE(message.find("x.sim"), std::string_view::npos) << message << "\nof\n" << text;
      EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 0) << message << "\nof\n" << text;
      ++n_refused_;
    }
  }

  const std::string good_ = R"(# a launch
k.cl  kernel_name
64 2 1   # global
32 1 1
<size=16 float range=1:0.5:2.5 dump ro>
<size=8 uint4 hex>
10 ff
<size=4>-7
<null>
<size=6 uchar file=six.bin wo>
<size=64 noinit>
<size=128>
<size=32 double fill=-1.5e3>
)";
  warpgrain::TemporaryFolder folder_;
  std::size_t n_accepted_ = 0, n_refused_ = 0;
  const std::vector<KernelParameter> parameters_{
      {"a", 8, 8, KernelParameter::Pointer::global}, {"b", 8, 8, KernelParameter::Pointer::global},
      {"c", 4, 4, KernelParameter::Pointer::none},   {"d", 8, 8, KernelParameter::Pointer::global},
      {"e", 8, 8, KernelParameter::Pointer::global}, {"f", 8, 8, KernelParameter::Pointer::constant},
      {"g", 8, 8, KernelParameter::Pointer::shared}, {"h", 8, 8, KernelParameter::Pointer::global}};
  const std::vector<ParameterDeclaration> declared_{{"a", "float*"}, {"b", "uint4*"}, {"c", "int"},
                                                    {"d", "int*"},   {"e", "uchar*"}, {"f", "S*"},
                                                    {"g", "int*"},   {"h", "double*"}};
};

TEST_F(DamagedLaunchFiles, CutAnywhere) {
  expect_answer(good_);
  ASSERT_EQ(n_accepted_, 1U);
  for (std::size_t size = 0; size < good_.size(); ++size) expect_answer(good_.substr(0, size));
  EXPECT_GT(n_refused_, good_.size() / 2);
}

TEST_F(DamagedLaunchFiles, BytesChangedAddedAndLost) {
  std::mt19937 random(fuzz_seed);
  SCOPED_TRACE(testing::Message() << "fuzz_seed " << fuzz_seed);
  const std::string likely = "<>#=: \n\t\0-+.x0159efNaninf\xff\x80";
  for (int i = 0; i < 4000; ++i) {
    std::string text = good_;
    for (int changes = 1 + static_cast<int>(random() % 3); changes > 0; --changes) {
      const std::size_t at = random() % text.size();
      const char byte = random() % 2 ? likely[random() % likely.size()] : static_cast<char>(random());
      switch (random() % 4) {
        case 0:
          text.erase(at, 1 + random() % 4);
          break;
        case 1:
          text.insert(at, 1, byte);
          break;
        default:
          text[at] = byte;
      }
      if (text.empty()) text = " ";
    }
    expect_answer(text);
  }
  EXPECT_GT(n_accepted_, 0U);
  EXPECT_GT(n_refused_, 1000U);
}

}  // namespace
}  // namespace warpgrain::profiler
