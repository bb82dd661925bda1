#pragma once
// OpenCL's scalar types by name, and values of them that are worth a look.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tests/profiler/builtins/random.hpp"

namespace warpgrain::profiler::builtins {

template <class T>
constexpr std::string_view name_of() {
  if constexpr (std::is_same_v<T, float>) return "float";
  if constexpr (std::is_same_v<T, double>) return "double";
  if constexpr (std::is_signed_v<T>)
    return sizeof(T) == 1 ? "char" : sizeof(T) == 2 ? "short" : sizeof(T) == 4 ? "int" : "long";
  return sizeof(T) == 1 ? "uchar" : sizeof(T) == 2 ? "ushort" : sizeof(T) == 4 ? "uint" : "ulong";
}

// Calls function(T()) for each type.
template <class... T, class Function>
void for_types(Function&& function) {
  (function(T()), ...);
}

template <class Function>
void for_integer_types(Function&& function) {
  for_types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t, std::uint32_t, std::int64_t,
            std::uint64_t>(function);
}

template <class Function>
void for_all_types(Function&& function) {
  for_integer_types(function);
  for_types<float, double>(function);
}

// Random values of every size.
template <class T>
T random_value(Random& random) {
  if constexpr (std::is_integral_v<T>) {
    return static_cast<T>(random.bits() >> random.below(64));
  } else {
    using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
    switch (random.below(3)) {
      case 0:
        return std::bit_cast<T>(static_cast<Bits>(random.bits()));
      case 1:
        return static_cast<T>(std::rint(random.between(-1000, 1000)) / 4);
      default:
        return static_cast<T>(std::ldexp(random.between(-1, 1), static_cast<int>(random.below(70))));
    }
  }
}

// The ends, zero, powers of two and halves between whole numbers, and what is next to them.
template <class T>
std::vector<T> edge_values() {
  using L = std::numeric_limits<T>;
  std::vector<T> values{0, 1, L::min(), L::max(), L::lowest()};
  if constexpr (std::is_integral_v<T>) {
    for (int bit = 1; bit < L::digits; ++bit) {
      const auto power = static_cast<T>(T(1) << bit);
      for (const int step : {-1, 0, 1}) {
        values.push_back(static_cast<T>(power + step));
        values.push_back(static_cast<T>(-power + step));
      }
      // Halfway between two floats or doubles, and next to it.
      for (const int digits : {24, 53})
        if (bit >= digits)
          for (const int step : {-1, 0, 1})
            values.push_back(static_cast<T>(power + (T(1) << (bit - digits)) + step));
    }
  } else {
    for (const T value :
         {L::infinity(), L::quiet_NaN(), L::denorm_min(), L::min() / 2, T(0.5), T(1.5), T(2.5)})
      values.insert(values.end(), {value, -value});
    values.push_back(T(-0.0));
    for (int bit = -1; bit <= 65; ++bit)
      for (const T offset : {T(-1), T(-0.5), T(0), T(0.5), T(1)}) {
        const T value = std::ldexp(T(1), bit) + offset;
        for (const T signed_value : {value, -value})
          values.insert(values.end(), {signed_value, std::nextafter(signed_value, L::infinity()),
                                       std::nextafter(signed_value, -L::infinity())});
      }
    if constexpr (sizeof(T) == 8) {
      // Where floats end, and halves between them.
      for (const T value : {0x1p-150, 0x1p-149, 0x1.8p-149, 0x1p-127, 0x1.000001p-127, 0x1.fffffep127,
                            0x1.ffffffp127, 0x1.000001p0, 0x1.000003p0})
        for (const T signed_value : {value, -value})
          values.insert(values.end(), {signed_value, std::nextafter(signed_value, L::infinity()),
                                       std::nextafter(signed_value, -L::infinity())});
    }
  }
  return values;
}

// Every width of vectors and 32 work-items in a group divide the number of samples.
constexpr std::size_t sample_block = 1536;

// Edges, then random values, as many as fill blocks.
template <class T>
std::vector<T> values_of(Random& random) {
  std::vector<T> values = edge_values<T>();
  const std::size_t count =
      (values.size() + sample_block / 4 + sample_block - 1) / sample_block * sample_block;
  while (values.size() < count) values.push_back(random_value<T>(random));
  return values;
}

}  // namespace warpgrain::profiler::builtins
