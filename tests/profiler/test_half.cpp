// Halfs against exact arithmetic: of the finite halfs around an exact value, the one that the rounding asks
// for.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "profiler/half.hpp"

namespace warpgrain::profiler {
namespace {

__extension__ using Exact = __float128;  // holds every a b + c of halfs
constexpr std::uint32_t half_seed = 20240602;

// What comes out when `value`, which is not a half, lies between the neighbours `below` and `above`.
std::uint16_t choose(Exact value, std::uint16_t below, std::uint16_t above, HalfRounding rounding) {
  const Exact low = half_to_float(below), high = half_to_float(above);
  const bool negative = value < 0;
  switch (rounding) {
    case HalfRounding::towards_zero:
      return negative ? above : below;
    case HalfRounding::down:
      return below;
    case HalfRounding::up:
      return above;
    case HalfRounding::to_nearest:
      break;
  }
  // An infinity stands for 65536, which would be next.
  const Exact high_end = std::isinf(half_to_float(above)) ? Exact(65536) : high;
  const Exact low_end = std::isinf(half_to_float(below)) ? Exact(-65536) : low;
  const Exact to_low = value - low_end, to_high = high_end - value;
  if (to_low != to_high) return to_low < to_high ? below : above;
  return (below & 1U) == 0 ? below : above;
}

// Ordered by value, from -infinity to infinity, each zero.
std::vector<std::uint16_t> ordered_halfs() {
  std::vector<std::uint16_t> bits;
  for (unsigned b = 0xfc00; b >= 0x8000; --b) bits.push_back(static_cast<std::uint16_t>(b));
  for (unsigned b = 0; b <= 0x7c00; ++b) bits.push_back(static_cast<std::uint16_t>(b));
  return bits;
}

std::uint16_t expected_half(Exact value, HalfRounding rounding) {
  static const std::vector<std::uint16_t> halfs = ordered_halfs();
  const auto above = std::lower_bound(halfs.begin(), halfs.end(), value,
                                      [](std::uint16_t bits, Exact v) { return half_to_float(bits) < v; });
  if (half_to_float(*above) == value) return *above;
  // Between zero and its neighbours, the zero of the value's sign.
  const std::uint16_t low = value > 0 && (above - 1)[0] == 0x8000 ? 0 : (above - 1)[0];
  return choose(value, low, *above, rounding);
}

double to_double(std::uint16_t bits) { return half_to_float(bits); }

TEST(Half, AsFloats) {
  EXPECT_EQ(half_to_float(0x3c00), 1.0F);
  EXPECT_EQ(half_to_float(0x8001), -0x1p-24F);
  EXPECT_EQ(half_to_float(0x03ff), 0x3ffp-24F);
  EXPECT_EQ(half_to_float(0x7bff), 65504.0F);
  EXPECT_EQ(half_to_float(0xfc00), -INFINITY);
  EXPECT_TRUE(std::isnan(half_to_float(0x7e00)));
  EXPECT_TRUE(std::signbit(half_to_float(0x8000)));
}

TEST(Half, EveryHalfStaysItself) {
  for (unsigned bits = 0; bits < 0x10000; ++bits) {
    const auto half = static_cast<std::uint16_t>(bits);
    for (const HalfRounding rounding :
         {HalfRounding::to_nearest, HalfRounding::towards_zero, HalfRounding::down, HalfRounding::up})
      if (std::isnan(to_double(half)))
        EXPECT_TRUE(std::isnan(to_double(double_to_half(to_double(half), rounding))));
      else
        EXPECT_EQ(double_to_half(to_double(half), rounding), half);
  }
}

TEST(Half, DoublesAreRoundedOnce) {
  std::mt19937_64 random(half_seed);
  std::vector<double> values{65504, 65519.999, 65520, 65536, 1e300, 0x1p-25, 0x1.000001p-25, 0x1p-26, 5e-324};
  std::uniform_real_distribution<double> mantissa(1, 2);
  for (int i = 0; i < 20000; ++i) {
    const int exponent = static_cast<int>(random() % 48) - 28;
    double value = std::ldexp(mantissa(random), exponent);
    // Ties and what lies next to them.
    if (i % 2 == 0) value = to_double(static_cast<std::uint16_t>(random() % 0x7c00)) + std::ldexp(1.0, -26);
    if (i % 4 == 0) {
      const auto bits = static_cast<std::uint16_t>(random() % 0x7bff);
      value = (to_double(bits) + to_double(static_cast<std::uint16_t>(bits + 1))) / 2;
    }
    values.push_back(value);
  }
  for (const double magnitude : values)
    for (const double value : {magnitude, -magnitude})
      for (const HalfRounding rounding :
           {HalfRounding::to_nearest, HalfRounding::towards_zero, HalfRounding::down, HalfRounding::up})
        ASSERT_EQ(double_to_half(value, rounding), expected_half(value, rounding))
            << value << " rounding " << static_cast<int>(rounding) << " half_seed " << half_seed;
}

TEST(Half, FusedMultiplyAddIsRoundedOnce) {
  std::mt19937_64 random(half_seed);
  for (int i = 0; i < 100000; ++i) {
    const auto any = [&] { return static_cast<std::uint16_t>(random() % 0x7c00 | (random() & 0x8000)); };
    const std::uint16_t a = any(), b = any();
    std::uint16_t c = any();
    // A sum far from the product's own size, which only a fused operation gets right.
    if (i % 2 == 0) c = double_to_half(to_double(a) * to_double(b), HalfRounding::down) ^ 0x8000;
    const Exact exact = Exact(to_double(a)) * to_double(b) + to_double(c);
    if (exact == 0 || std::isinf(to_double(c))) continue;
    ASSERT_EQ(fma_half(a, b, c), expected_half(exact, HalfRounding::to_nearest))
        << std::hex << a << ' ' << b << ' ' << c << " half_seed " << std::dec << half_seed;
  }
}

}  // namespace
}  // namespace warpgrain::profiler
