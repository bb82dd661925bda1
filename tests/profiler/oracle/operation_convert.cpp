// Conversions and moves.

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "tests/profiler/oracle/operation.hpp"

namespace warpgrain::oracle {
namespace {

// The integral value nearest by the rounding's name.
template <class T>
T integral(const std::string& rounding, T x) {
  if (rounding == "rzi") return std::trunc(x);
  if (rounding == "rmi") return std::floor(x);
  if (rounding == "rpi") return std::ceil(x);
  if (rounding == "rni") return std::nearbyint(x);  // the rounding mode of the process: ties to even
  return x;
}

// Beyond the range to its end, NaN to 0.
template <class To, class From>
To clamped(From x) {
  using Limits = std::numeric_limits<To>;
  if (std::isnan(x)) return 0;
  // 2^digits, which a float can hold, is the first value above the range.
  if (x >= std::ldexp(From{1}, Limits::digits)) return Limits::max();
  if (x <= static_cast<From>(Limits::min())) return Limits::min();
  return static_cast<To>(x);
}

template <class To, class From>
To clamped_integer(From x) {
  using Limits = std::numeric_limits<To>;
  if (std::cmp_less(x, Limits::min())) return Limits::min();
  if (std::cmp_greater(x, Limits::max())) return Limits::max();
  return static_cast<To>(x);
}

template <class F>
auto with_number(const ptx::Statement& s, ptx::ScalarType type, F&& function) {
  return type.is_float() ? with_float(s, type, function) : with_integer(s, type, function);
}

// The value of a half by its definition: 1 sign, 5 exponent and 10 fraction bits.
float value_of_half(Bits bits) {
  const auto exponent = static_cast<int>(bits >> 10 & 0x1f), fraction = static_cast<int>(bits & 0x3ff);
  const float sign = (bits & 0x8000) != 0 ? -1.0F : 1.0F;
  if (exponent == 0x1f) return fraction != 0 ? std::numeric_limits<float>::quiet_NaN() : sign * HUGE_VALF;
  const int significand = exponent == 0 ? fraction : 0x400 + fraction;
  return sign * std::ldexp(static_cast<float>(significand), std::max(exponent, 1) - 25);
}

// The half nearest to x, ties to even.
Bits half_nearest(float x) {
  if (std::isnan(x)) return 0x7fff;
  const Bits sign = std::signbit(x) ? 0x8000 : 0;
  int exponent = 0;
  std::frexp(x, &exponent);
  const int lowest_bit = std::max(exponent - 11, -24);
  const float rounded = std::ldexp(std::nearbyint(std::ldexp(std::fabs(x), -lowest_bit)), lowest_bit);
  if (!(rounded < 65536.0F)) return sign | 0x7c00;
  for (Bits bits = 0;; bits += 0x400)  // the last power of two that is not above it, then the rest
    if (value_of_half(bits + 0x400) > rounded || bits == 0x7800)
      return sign | (bits + static_cast<Bits>((rounded - value_of_half(bits)) /
                                              (value_of_half(bits + 1) - value_of_half(bits))));
}

Operation conversion(const ptx::Statement& s) {
  Modifiers modifiers(s);
  const std::string rounding = modifiers.take_one_of({"rn", "rni", "rzi", "rmi", "rpi"});
  const bool flushes = modifiers.take("ftz"), saturates = modifiers.take("sat");
  const ptx::ScalarType to = modifiers.take_type(), from = modifiers.take_type();
  modifiers.finish();
  if (from.is_float() && from.bits == 16 && to.is_float() && to.bits == 32)
    return {{from}, to, [](const Bits* in) { return bits_of(value_of_half(in[0])); }};
  if (to.is_float() && to.bits == 16 && from.is_float() && from.bits == 32 && rounding == "rn")
    return {{from}, to, [](const Bits* in) { return half_nearest(value_of<float>(in[0])); }};
  const auto flushing = [flushes](auto x) { return flushes ? flushed(x) : x; };
  if (saturates && (to.is_float() || from.is_float())) refuse(s, ".sat between integers alone");
  Operation operation{{from}, to, {}};
  operation.compute = with_number(s, from, [&](auto source) {
    using From = decltype(source);
    return with_number(s, to, [&](auto target) -> std::function<Bits(const Bits*)> {
      using To = decltype(target);
      if constexpr (std::is_floating_point_v<From> && std::is_floating_point_v<To>)
        return [rounding, flushing](const Bits* in) {
          return bits_of(flushing(static_cast<To>(integral(rounding, flushing(value_of<From>(in[0]))))));
        };
      else if constexpr (std::is_floating_point_v<From>)
        return [rounding, flushing](const Bits* in) {
          return bits_of(clamped<To>(integral(rounding, flushing(value_of<From>(in[0])))));
        };
      else if constexpr (std::is_floating_point_v<To>)
        return [](const Bits* in) { return bits_of(static_cast<To>(value_of<From>(in[0]))); };
      else if (saturates)
        return [](const Bits* in) { return bits_of(clamped_integer<To>(value_of<From>(in[0]))); };
      else
        return [](const Bits* in) { return bits_of(static_cast<To>(value_of<From>(in[0]))); };
    });
  });
  return operation;
}

}  // namespace

Operation convert_operation(const ptx::Statement& statement) {
  if (statement.opcode == "cvt") return conversion(statement);
  if (statement.opcode != "mov" && statement.opcode != "cvta") return {};
  Modifiers modifiers(statement);
  if (statement.opcode == "cvta") {  // addresses of every space are generic ones
    modifiers.take("to");
    modifiers.take_one_of({"global", "shared", "local", "const", "param"});
  }
  const ptx::ScalarType type = modifiers.take_type();
  modifiers.finish();
  return {{type}, type, [](const Bits* in) { return in[0]; }};
}

}  // namespace warpgrain::oracle
