// Integer functions (section 6.12.3) of every type and width, bit by bit.

#include <bit>
#include <gtest/gtest.h>

#include "tests/profiler/builtins/scalar_types.hpp"
#include "tests/profiler/builtins/switch_program.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler::builtins {
namespace {

// Holds every sum and product of 64-bit numbers.
__extension__ typedef __int128 Wide;

template <class T>
T saturated(Wide value) {
  using L = std::numeric_limits<T>;
  return value < Wide(L::min()) ? L::min() : value > Wide(L::max()) ? L::max() : static_cast<T>(value);
}

// An unsigned product of 64-bit numbers does not fit: half of it is taken apart.
template <class T>
T high_of_product(T x, T y) {
  constexpr int bits = 8 * sizeof(T);
  if constexpr (std::is_signed_v<T> || bits < 64) {
    return static_cast<T>((Wide(x) * Wide(y)) >> bits);
  } else {
    __extension__ typedef unsigned __int128 UnsignedWide;
    return static_cast<T>((UnsignedWide(x) * y) >> 64);
  }
}

template <class T>
T low_24_bits(T x) {
  return static_cast<T>(
      std::is_signed_v<T> ? static_cast<T>(static_cast<std::make_unsigned_t<T>>(x) << 8) >> 8 : x & 0xffffff);
}

template <class T>
struct IntegerFunction {
  std::string_view call;  // over x, y, z
  T (*reference)(T x, T y, T z);
  bool (*defined)(T x, T y, T z) = nullptr;  // null: always
};

template <class T>
std::vector<IntegerFunction<T>> functions(std::uint32_t width) {
  using U = std::make_unsigned_t<T>;
  constexpr int bits = 8 * sizeof(T);
  std::vector<IntegerFunction<T>> all{
      {"x + y", [](T x, T y, T) { return static_cast<T>(U(x) + U(y)); }},
      {"x - y", [](T x, T y, T) { return static_cast<T>(U(x) - U(y)); }},
      {"x * y", [](T x, T y, T) { return static_cast<T>(std::uint64_t(x) * std::uint64_t(y)); }},
      {"x / y", [](T x, T y, T) { return static_cast<T>(Wide(x) / Wide(y)); },
       [](T, T y, T) { return y != 0; }},
      {"x % y", [](T x, T y, T) { return static_cast<T>(Wide(x) % Wide(y)); },
       [](T, T y, T) { return y != 0; }},
      {"as_V(abs(x))", [](T x, T, T) { return static_cast<T>(x < 0 ? -Wide(x) : Wide(x)); }},
      {"as_V(abs_diff(x, y))",
       [](T x, T y, T) { return static_cast<T>(x < y ? Wide(y) - Wide(x) : Wide(x) - Wide(y)); }},
      {"add_sat(x, y)", [](T x, T y, T) { return saturated<T>(Wide(x) + Wide(y)); }},
      {"sub_sat(x, y)", [](T x, T y, T) { return saturated<T>(Wide(x) - Wide(y)); }},
      {"hadd(x, y)", [](T x, T y, T) { return static_cast<T>((Wide(x) + Wide(y)) >> 1); }},
      {"rhadd(x, y)", [](T x, T y, T) { return static_cast<T>((Wide(x) + Wide(y) + 1) >> 1); }},
      {"clamp(x, y, z)", [](T x, T y, T z) { return std::min(std::max(x, y), z); },
       [](T, T y, T z) { return y <= z; }},
      {"clz(x)", [](T x, T, T) { return static_cast<T>(std::countl_zero(U(x))); }},
      {"mad_hi(x, y, z)", [](T x, T y, T z) { return static_cast<T>(U(high_of_product(x, y)) + U(z)); }},
      {"max(x, y)", [](T x, T y, T) { return std::max(x, y); }},
      {"min(x, y)", [](T x, T y, T) { return std::min(x, y); }},
      {"mul_hi(x, y)", [](T x, T y, T) { return high_of_product(x, y); }},
      {"rotate(x, y)", [](T x, T y, T) { return static_cast<T>(std::rotl(U(x), int(U(y) % bits))); }},
      {"popcount(x)", [](T x, T, T) { return static_cast<T>(std::popcount(U(x))); }},
  };
  // The product of unsigned 64-bit numbers may reach 2^127 and more, where the sum goes beyond even Wide.
  if constexpr (std::is_signed_v<T> || bits < 64)
    all.push_back(
        {"mad_sat(x, y, z)", [](T x, T y, T z) { return saturated<T>(Wide(x) * Wide(y) + Wide(z)); }});
  else
    all.push_back({"mad_sat(x, y, z)", [](T x, T y, T z) {
                     return high_of_product(x, y) != 0 || T(x * y + z) < z ? std::numeric_limits<T>::max()
                                                                           : T(x * y + z);
                   }});
  // A scalar char or short is shifted as an int; that is the compiler's business.
  if (bits >= 32 || width > 1) {
    all.push_back({"x << y", [](T x, T y, T) { return static_cast<T>(U(x) << (y & (bits - 1))); }});
    all.push_back({"x >> y", [](T x, T y, T) { return static_cast<T>(x >> (y & (bits - 1))); }});
  }
  if constexpr (bits == 32) {
    const auto fits = [](T x, T y, T) { return x == low_24_bits(x) && y == low_24_bits(y); };
    all.push_back({"mul24(x, y)", [](T x, T y, T) { return static_cast<T>(U(x) * U(y)); }, fits});
    all.push_back({"mad24(x, y, z)", [](T x, T y, T z) { return static_cast<T>(U(x) * U(y) + U(z)); }, fits});
  }
  return all;
}

template <class T>
std::vector<Expression> expressions_of(const std::vector<IntegerFunction<T>>& functions,
                                       std::uint32_t width) {
  std::vector<Expression> expressions;
  const std::string vector = std::string(name_of<T>()) + (width == 1 ? "" : std::to_string(width));
  for (const IntegerFunction<T>& f : functions) {
    std::string text(f.call);
    if (const auto at = text.find("as_V"); at != std::string::npos) text.replace(at, 4, "as_" + vector);
    expressions.push_back({text, std::string(name_of<T>())});
  }
  return expressions;
}

// Values with 24 bits are what mul24 takes.
template <class T>
std::vector<T> inputs(Random& random) {
  std::vector<T> values = values_of<T>(random);
  if constexpr (sizeof(T) == 4)
    for (std::size_t i = 512; i < 1024; ++i) values[i] = low_24_bits(values[i]);
  return values;
}

template <class T>
void shuffle(std::vector<T>& values, std::size_t first, std::size_t last, Random& random) {
  for (std::size_t i = first; i < last; ++i) std::swap(values[i], values[first + random.below(last - first)]);
}

template <class T>
void expect_integer_functions(std::uint32_t width) {
  Random random;
  std::vector<T> x = inputs<T>(random), y = inputs<T>(random), z = inputs<T>(random);
  for (std::vector<T>* values : {&y, &z})
    for (const std::size_t third : {0, 512, 1024}) shuffle(*values, third, third + 512, random);
  const std::vector<IntegerFunction<T>> all = functions<T>(width);
  const auto executable = compile_kernel(switch_program(name_of<T>(), width, expressions_of(all, width)),
                                         "measured", TraceMode::none);
  for (std::size_t f = 0; f < all.size(); ++f) {
    std::vector<T> results(x.size());
    const int which = static_cast<int>(f);
    run_launch(*executable, line_of(x.size() / width, 32),
               {buffer_of(results), buffer_of(x), buffer_of(y), buffer_of(z), scalar_of(which)});
    int failures = 0;
    for (std::size_t i = 0; i < x.size() && failures < 3; ++i) {
      if (all[f].defined && !all[f].defined(x[i], y[i], z[i])) continue;
      const T expected = all[f].reference(x[i], y[i], z[i]);
      if (expected == results[i]) continue;
      ++failures;
      ADD_FAILURE() << fmt::format("{}{}: {} with x = {}, y = {}, z = {} gives {}, not {}; seed {}",
                                   name_of<T>(), width, all[f].call, x[i], y[i], z[i], results[i], expected,
                                   seed);
    }
  }
}

class IntegerFunctions : public testing::TestWithParam<std::uint32_t> {};

TEST_P(IntegerFunctions, OfWidth) {
  for_integer_types([]<class T>(T) { expect_integer_functions<T>(GetParam()); });
}

INSTANTIATE_TEST_SUITE_P(Widths, IntegerFunctions, testing::Values(1, 3, 16),
                         [](const auto& tested) { return std::to_string(tested.param); });

// upsample(high, low): the low half is always unsigned.
template <class Half, class Whole>
void expect_upsample() {
  Random random;
  std::vector<Half> high = values_of<Half>(random), low = values_of<Half>(random);
  shuffle(low, 0, low.size(), random);
  const std::string unsigned_half = fmt::format("as_{}4(y)", name_of<std::make_unsigned_t<Half>>());
  const auto executable =
      compile_kernel(switch_program(name_of<Half>(), 4,
                                    {{"upsample(x, " + unsigned_half + ")", std::string(name_of<Whole>())}}),
                     "measured", TraceMode::none);
  std::vector<Whole> results(high.size());
  const int which = 0;
  run_launch(*executable, line_of(high.size() / 4, 32),
             {buffer_of(results), buffer_of(high), buffer_of(low), buffer_of(low), scalar_of(which)});
  for (std::size_t i = 0; i < high.size(); ++i) {
    const auto expected = static_cast<Whole>((Wide(high[i]) << (8 * sizeof(Half))) |
                                             static_cast<std::make_unsigned_t<Half>>(low[i]));
    ASSERT_EQ(results[i], expected) << name_of<Half>() << ", seed " << seed;
  }
}

TEST(Upsample, OfEveryType) {
  expect_upsample<std::int8_t, std::int16_t>();
  expect_upsample<std::uint8_t, std::uint16_t>();
  expect_upsample<std::int16_t, std::int32_t>();
  expect_upsample<std::uint16_t, std::uint32_t>();
  expect_upsample<std::int32_t, std::int64_t>();
  expect_upsample<std::uint32_t, std::uint64_t>();
}

}  // namespace
}  // namespace warpgrain::profiler::builtins
