// vload_half of every bit pattern, and vstore_half in every rounding mode (section 6.12.7), against exact
// arithmetic.

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numeric>
#include <string>

#include "tests/profiler/builtins/scalar_types.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler::builtins {
namespace {

double value_of_half(std::uint16_t bits) {
  const int exponent = (bits >> 10) & 0x1f, mantissa = bits & 0x3ff;
  const double magnitude = exponent == 31  ? (mantissa ? NAN : INFINITY)
                           : exponent == 0 ? std::ldexp(mantissa, -24)
                                           : std::ldexp(mantissa + 1024, exponent - 25);
  return bits & 0x8000 ? -magnitude : magnitude;
}

double to_nearest(double x) { return std::nearbyint(x); }
double towards_zero(double x) { return std::trunc(x); }
double up(double x) { return std::ceil(x); }
double down(double x) { return std::floor(x); }

struct Mode {
  const char* suffix;
  double (*whole)(double);
};

constexpr Mode modes[] = {
    {"", to_nearest}, {"_rte", to_nearest}, {"_rtz", towards_zero}, {"_rtp", up}, {"_rtn", down}};

// The half next to x in the mode's direction, as a number.
double rounded_to_half(double x, const Mode& mode) {
  if (x == 0 || !std::isfinite(x)) return x;
  const double unit = std::ldexp(1.0, std::max(std::ilogb(x), -14) - 10);
  const double rounded = std::copysign(mode.whole(x / unit) * unit, x);
  if (std::abs(rounded) <= 65504) return rounded;
  // Beyond the greatest number; it stays where the mode leads back to it.
  const bool stays = mode.whole == towards_zero || mode.whole == (x > 0 ? down : up);
  return std::copysign(stays ? 65504 : INFINITY, x);
}

TEST(HalfMemory, LoadsEveryPattern) {
  const auto executable = compile_kernel(
      "kernel void load(global float* one, global float* many, global const half* halves) {\n"
      "  const size_t i = get_global_id(0);\n  one[i] = vload_half(i, halves);\n"
      "  if (i % 4 == 0) vstore4(vload_half4(i / 4, halves), i / 4, many);\n}\n",
      "load", TraceMode::none);
  std::vector<std::uint16_t> halves(65536);
  std::iota(halves.begin(), halves.end(), std::uint16_t(0));
  std::vector<float> one(halves.size()), many(halves.size());
  run_launch(*executable, line_of(halves.size(), 64), {buffer_of(one), buffer_of(many), buffer_of(halves)});
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const double expected = value_of_half(halves[i]);
    for (const float got : {one[i], many[i]})
      ASSERT_TRUE((std::isnan(expected) && std::isnan(got)) ||
                  (expected == got && std::signbit(expected) == std::signbit(got)))
          << fmt::format("{:#x}: {}, not {}", i, got, expected);
  }
}

// Around every half and half way to the next one.
template <class T>
std::vector<T> values_around_halves(Random& random) {
  std::vector<T> values = values_of<T>(random);
  while (values.size() < 12 * sample_block) {
    const auto bits = static_cast<std::uint16_t>(random.bits());
    const T value = static_cast<T>(value_of_half(bits));
    const T between =
        static_cast<T>((value_of_half(bits) + value_of_half(static_cast<std::uint16_t>(bits + 1))) / 2);
    values.insert(values.end(),
                  {value, std::nextafter(value, T(0)), between, std::nextafter(between, T(INFINITY))});
  }
  values.resize(12 * sample_block);
  return values;
}

template <class T>
void expect_stores() {
  Random random;
  std::vector<T> values = values_around_halves<T>(random);
  std::string text = fmt::format(
      "kernel void store(global half* one, global half* many, global const {0}* values, int mode) {{\n"
      "  const size_t i = get_global_id(0);\n  switch (mode) {{\n",
      name_of<T>());
  for (std::size_t m = 0; m < std::size(modes); ++m)
    text += fmt::format(
        "    case {0}:\n      vstore_half{1}(values[i], i, one);\n"
        "      if (i % 4 == 0) vstore_half4{1}(vload4(i / 4, values), i / 4, many);\n      break;\n",
        m, modes[m].suffix);
  const auto executable = compile_kernel(text + "  }\n}\n", "store", TraceMode::none);
  for (int m = 0; m < static_cast<int>(std::size(modes)); ++m) {
    std::vector<std::uint16_t> one(values.size()), many(values.size());
    run_launch(*executable, line_of(values.size(), 64),
               {buffer_of(one), buffer_of(many), buffer_of(values), scalar_of(m)});
    int failures = 0;
    for (std::size_t i = 0; i < values.size() && failures < 3; ++i)
      for (const std::uint16_t bits : {one[i], many[i]}) {
        const double expected = rounded_to_half(values[i], modes[m]), got = value_of_half(bits);
        if ((std::isnan(expected) && std::isnan(got)) ||
            (expected == got && std::signbit(expected) == std::signbit(got)))
          continue;
        ++failures;
        ADD_FAILURE() << fmt::format("vstore_half{}({} {:a}) = {:a}, not {:a}; seed {}", modes[m].suffix,
                                     name_of<T>(), values[i], got, expected, seed);
      }
  }
}

TEST(HalfMemory, StoresFloatsInEveryMode) { expect_stores<float>(); }
TEST(HalfMemory, StoresDoublesInEveryMode) { expect_stores<double>(); }

}  // namespace
}  // namespace warpgrain::profiler::builtins
