#include <array>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "profiler/printf_format.hpp"

namespace warpgrain::profiler {
namespace {

class Given final : public PrintfArguments {
 public:
  template <class... Values>
  explicit Given(Values... values)  // by value: a literal becomes its address
  {
    (add(values), ...);
  }
  std::span<const std::byte> next(std::size_t bytes) override {
    asked_.push_back(bytes);
    if (next_ == values_.size()) return {};
    return values_[next_++];
  }
  std::string_view text_at(const char* address) override { return address; }
  std::vector<std::size_t> asked_;

 private:
  template <class Value>
  void add(const Value& value) {
    const auto bytes = std::as_bytes(std::span(&value, 1));
    values_.emplace_back(bytes.begin(), bytes.end());
  }
  std::vector<std::vector<std::byte>> values_;
  std::size_t next_ = 0;
};

template <class... Values>
std::string format(std::string_view text, Values... values) {
  Given given(values...);
  return format_printf(text, given);
}

TEST(PrintfFormat, ScalarsAsC) {
  EXPECT_EQ(format("%d %5.3i|%-4u|%+ld %lx %o %#X %c%%\n", -1, 7, 8U, 9L, 255UL, 8U, 255U, int{'x'}),
            "-1   007|8   |+9 ff 10 0XFF x%\n");
  EXPECT_EQ(format("%hhd %hd %hhu %hu", 255, 65535, -1, -1), "-1 -1 255 65535");
  EXPECT_EQ(format("%f %.1e %g %a", 0.5, 12345.0, 1e-10, 1.0), "0.500000 1.2e+04 1e-10 0x1p+0");
  EXPECT_EQ(format("%s|%5s|%.1s|%s", "ab", "cd", "ef", static_cast<const char*>(nullptr)),
            "ab|   cd|e|(null)");
  EXPECT_EQ(format("%p", reinterpret_cast<const void*>(0x10)), "0x10");
}

TEST(PrintfFormat, VectorsElementByElement) {
  const std::array<float, 4> floats{1, 2.5F, -3, 0};
  EXPECT_EQ(format("%v4hlf", floats), "1.000000,2.500000,-3.000000,0.000000");
  EXPECT_EQ(format("%5.1v3f|", floats), "  1.0,  2.5, -3.0|");
  EXPECT_EQ(format("%v2ld %v4hhu %v2hx", std::array<long, 2>{-1, 2}, std::array<signed char, 4>{-1, 2, 3, 4},
                   std::array<short, 2>{-1, 16}),
            "-1,2 255,2,3,4 ffff,10");
  EXPECT_EQ(format("%v16d", std::array<int, 16>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}),
            "0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15");
  EXPECT_EQ(format("%v2hf", std::array<std::uint16_t, 2>{0x3c00, 0xc000}), "1.000000,-2.000000");
}

TEST(PrintfFormat, TheArgumentsOwnSizeWins) {
  EXPECT_EQ(format("%d %ld %f", std::int64_t{-2}, -3, 0.5F), "-2 -3 0.500000");
}

TEST(PrintfFormat, AsksForWhatTheConversionSays) {
  Given given(0, 0, 0L, 0.0, std::array<char, 4>{}, std::array<float, 4>{}, "x");
  format_printf("%hhd%c%ld%f%v3hhd%v4hlf%s", given);
  EXPECT_EQ(given.asked_, (std::vector<std::size_t>{4, 4, 8, 8, 4, 16, 8}));
}

TEST(PrintfFormat, WhatCannotBePrintedStands) {
  EXPECT_EQ(format("%d %d", 1), "1 %d");
  EXPECT_EQ(format("%n|%v5d|%v4s|%|%99999999d|%", 1), "%n|%v5d|%v4s|%|%99999999d|%");
  EXPECT_EQ(format("100%"), "100%");
}

TEST(PrintfFormat, LongTextsAreWhole) {
  EXPECT_EQ(format("%1000d", 1).size(), 1000U);
  EXPECT_EQ(format("%f", 1e300).size(), 308U);
}

}  // namespace
}  // namespace warpgrain::profiler
