#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "profiler/kernel_name.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

using testing::HasSubstr;

// reduce<float>(float*), reduce<int>(int*), ns::scan(int*), ns::(anonymous namespace)::hidden(void (*)(int)),
// plain
constexpr std::array<std::string_view, 5> symbols{"_Z6reduceIfEvPT_", "_Z6reduceIiEvPT_", "_ZN2ns4scanEPi",
                                                  "_ZN2ns12_GLOBAL__N_16hiddenEPFviE", "plain"};

TEST(KernelName, IsReadWithoutItsParameters) {
  EXPECT_EQ(readable_kernel_name("_Z6reduceIfEvPT_"), "reduce<float>");
  EXPECT_EQ(readable_kernel_name("_ZN2ns4scanEPi"), "ns::scan");
  EXPECT_EQ(readable_kernel_name("_ZN2ns12_GLOBAL__N_16hiddenEPFviE"), "ns::(anonymous namespace)::hidden");
  EXPECT_EQ(readable_kernel_name("plain"), "plain");
}

TEST(KernelName, FitsAsSymbolOrAsTheSourceHasIt) {
  const auto found = [](std::string_view asked) { return find_kernel(symbols, asked, "k.ptx"); };
  EXPECT_EQ(found("plain"), "plain");
  EXPECT_EQ(found("_ZN2ns4scanEPi"), "_ZN2ns4scanEPi");
  EXPECT_EQ(found("scan"), "_ZN2ns4scanEPi");
  EXPECT_EQ(found("ns::scan"), "_ZN2ns4scanEPi");
  EXPECT_EQ(found("reduce<int>"), "_Z6reduceIiEvPT_");
  EXPECT_EQ(found("hidden"), "_ZN2ns12_GLOBAL__N_16hiddenEPFviE");
}

TEST(KernelName, RefusesNamesOfNoneAndOfSeveral) {
  EXPECT_THAT(
      refusal([] { find_kernel(symbols, "reduce", "k.ptx"); }),
      HasSubstr("k.ptx: kernel 'reduce' is one of several; expected one of reduce<float>, reduce<int>"));
  EXPECT_THAT(refusal([] { find_kernel(symbols, "gone", "k.ptx"); }),
              HasSubstr("valid: reduce<float>, reduce<int>, ns::scan"));
}

}  // namespace
}  // namespace warpgrain::profiler
