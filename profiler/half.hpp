#pragma once
// IEEE binary16 in its bits.

#include <bit>
#include <cstdint>

namespace warpgrain::profiler {

constexpr float half_to_float(std::uint16_t bits) {
  const std::uint32_t sign = static_cast<std::uint32_t>(bits & 0x8000U) << 16;
  const std::uint32_t exponent = bits >> 10 & 0x1fU;
  const std::uint32_t fraction = bits & 0x3ffU;
  if (exponent == 0x1f) return std::bit_cast<float>(sign | 0x7f800000U | fraction << 13);
  if (exponent != 0) return std::bit_cast<float>(sign | (exponent + 112) << 23 | fraction << 13);
  // Subnormal: a multiple of 2^-24, which a float holds exactly.
  const float magnitude = static_cast<float>(fraction) * 0x1p-24F;
  return std::bit_cast<float>(sign | std::bit_cast<std::uint32_t>(magnitude));
}

enum class HalfRounding : std::uint8_t { to_nearest, towards_zero, down, up };

// Rounded once. NaN becomes the quiet NaN of all fraction bits, as PTX has it.
std::uint16_t double_to_half(double value, HalfRounding rounding);

// a b + c, rounded once, to nearest.
std::uint16_t fma_half(std::uint16_t a, std::uint16_t b, std::uint16_t c);

}  // namespace warpgrain::profiler
