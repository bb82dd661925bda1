#include "profiler/half.hpp"

#include <algorithm>
#include <cmath>

namespace warpgrain::profiler {
namespace {

constexpr double greatest = 65504;
constexpr std::uint16_t infinity_bits = 0x7c00;
constexpr std::uint16_t nan_bits = 0x7fff;

// An exact quotient of `value`, rounded to a whole number.
double round_to_whole(double value, HalfRounding rounding) {
  switch (rounding) {
    case HalfRounding::to_nearest:
      return std::nearbyint(value);
    case HalfRounding::towards_zero:
      return std::trunc(value);
    case HalfRounding::down:
      return std::floor(value);
    case HalfRounding::up:
      break;
  }
  return std::ceil(value);
}

// a + b, of which the last bit is set when bits below it are lost: rounding that to 11 bits is as if the sum
// had been exact (S. Boldo, G. Melquiond, "Emulation of FMA and correctly rounded sums: proved algorithms
// using rounding to odd", 2008).
double add_to_odd(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double lost = (a - (sum - b_part)) + (b - b_part);
  const auto bits = std::bit_cast<std::uint64_t>(sum);
  if (lost == 0 || !std::isfinite(sum) || (bits & 1U) != 0) return sum;
  return std::bit_cast<double>(std::signbit(lost) == std::signbit(sum) ? bits + 1 : bits - 1);
}

}  // namespace

std::uint16_t double_to_half(double value, HalfRounding rounding) {
  if (std::isnan(value)) return nan_bits;
  const std::uint16_t sign = std::signbit(value) ? 0x8000 : 0;
  if (std::isinf(value)) return sign | infinity_bits;
  // The distance of halfs at the value: 2^-10 of its power of two, at least 2^-24.
  const int exponent = value == 0 ? -14 : std::max(std::ilogb(value), -14);
  const double unit = std::ldexp(1.0, exponent - 10);
  const double rounded = round_to_whole(value / unit, rounding) * unit;
  const double magnitude = std::abs(rounded);
  if (magnitude > greatest) {
    const bool stays_finite = rounding == HalfRounding::towards_zero ||
                              rounding == (sign != 0 ? HalfRounding::up : HalfRounding::down);
    return sign | (stays_finite ? infinity_bits - 1 : infinity_bits);
  }
  if (magnitude < 0x1p-14) return sign | static_cast<std::uint16_t>(magnitude * 0x1p24);
  const int of_rounded = std::ilogb(magnitude);
  const auto fraction = static_cast<std::uint16_t>(std::ldexp(magnitude, 10 - of_rounded) - 1024);
  return static_cast<std::uint16_t>(sign | (of_rounded + 15) << 10 | fraction);
}

std::uint16_t fma_half(std::uint16_t a, std::uint16_t b, std::uint16_t c) {
  // The product of two halfs is exact in double.
  const double product = static_cast<double>(half_to_float(a)) * half_to_float(b);
  return double_to_half(add_to_odd(product, half_to_float(c)), HalfRounding::to_nearest);
}

}  // namespace warpgrain::profiler
