#include "profiler/directed_rounding.hpp"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdint>

namespace warpgrain::profiler {
namespace {

class RoundingScope {
 public:
  explicit RoundingScope(int mode) : before_(std::fegetround()) { std::fesetround(mode); }
  ~RoundingScope() { std::fesetround(before_); }
  RoundingScope(const RoundingScope&) = delete;
  RoundingScope& operator=(const RoundingScope&) = delete;

 private:
  int before_;
};

// The compiler knows nothing of rounding modes: volatile keeps each operation between the two changes of
// mode.
template <int mode, class T>
T add(T a, T b) {
  const volatile T x = a, y = b;
  const RoundingScope scope(mode);
  const volatile T result = x + y;
  return result;
}

template <int mode, class T>
T multiply(T a, T b) {
  const volatile T x = a, y = b;
  const RoundingScope scope(mode);
  const volatile T result = x * y;
  return result;
}

template <int mode, class T>
T divide(T a, T b) {
  const volatile T x = a, y = b;
  const RoundingScope scope(mode);
  const volatile T result = x / y;
  return result;
}

template <int mode, class T>
T fused_multiply_add(T a, T b, T c) {
  const volatile T x = a, y = b, z = c;
  const RoundingScope scope(mode);
  const volatile T result = std::fma(x, y, z);
  return result;
}

template <int mode, class T>
T square_root(T a) {
  const volatile T x = a;
  const RoundingScope scope(mode);
  const volatile T result = std::sqrt(x);
  return result;
}

template <int mode, class To, class From>
To convert(From a) {
  const volatile From x = a;
  const RoundingScope scope(mode);
  const volatile To result = static_cast<To>(x);
  return result;
}

// The bits of a half: 11 bits of mantissa, exponents from -14 on, the largest 65504.
template <int mode>
std::uint16_t to_half(double a) {
  const std::uint16_t sign = std::signbit(a) ? 0x8000 : 0;
  if (std::isnan(a)) return 0x7fff;
  if (std::isinf(a)) return sign | 0x7c00;
  if (a == 0) return sign;
  int exponent = std::max(std::ilogb(a), -14);
  const volatile double units = std::ldexp(a, 10 - exponent);
  double rounded = 0;
  {
    const RoundingScope scope(mode);
    rounded = std::fabs(std::nearbyint(units));
  }
  if (rounded >= 2048) rounded = 1024, ++exponent;
  if (exponent > 15) {
    const bool to_infinity = mode == (sign != 0 ? FE_DOWNWARD : FE_UPWARD);
    return sign | (to_infinity ? 0x7c00 : 0x7bff);
  }
  const auto mantissa = static_cast<std::uint16_t>(rounded);
  // A subnormal has the exponent's field 0, like the bits above its mantissa.
  return static_cast<std::uint16_t>(sign + ((exponent + 14) << 10) + mantissa);
}

template <int mode, class T>
void add_arithmetic(std::vector<HostFunction>& functions, const std::string& rounding,
                    const std::string& type) {
  const std::string end = "_" + rounding + "_" + type;
  functions.push_back(host_function("warpgrain_add" + end, add<mode, T>));
  functions.push_back(host_function("warpgrain_mul" + end, multiply<mode, T>));
  functions.push_back(host_function("warpgrain_div" + end, divide<mode, T>));
  functions.push_back(host_function("warpgrain_fma" + end, fused_multiply_add<mode, T>));
  functions.push_back(host_function("warpgrain_sqrt" + end, square_root<mode, T>));
}

template <int mode>
void add_mode(std::vector<HostFunction>& functions, const std::string& rounding) {
  add_arithmetic<mode, float>(functions, rounding, "f32");
  add_arithmetic<mode, double>(functions, rounding, "f64");
  functions.push_back(host_function("warpgrain_f16_" + rounding + "_f64", to_half<mode>));
  functions.push_back(host_function("warpgrain_f32_" + rounding + "_f64", convert<mode, float, double>));
  functions.push_back(
      host_function("warpgrain_f32_" + rounding + "_s64", convert<mode, float, std::int64_t>));
  functions.push_back(
      host_function("warpgrain_f32_" + rounding + "_u64", convert<mode, float, std::uint64_t>));
  functions.push_back(
      host_function("warpgrain_f64_" + rounding + "_s64", convert<mode, double, std::int64_t>));
  functions.push_back(
      host_function("warpgrain_f64_" + rounding + "_u64", convert<mode, double, std::uint64_t>));
}

}  // namespace

std::vector<HostFunction> directed_functions() {
  std::vector<HostFunction> functions;
  add_mode<FE_TOWARDZERO>(functions, "rz");
  add_mode<FE_DOWNWARD>(functions, "rm");
  add_mode<FE_UPWARD>(functions, "rp");
  return functions;
}

}  // namespace warpgrain::profiler
