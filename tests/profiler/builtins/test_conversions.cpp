// convert_T{_sat}{_rte,_rtz,_rtp,_rtn} between all types (section 6.2.3), scalars and vectors.

#include <cfenv>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <optional>

#include "tests/profiler/builtins/exact_value.hpp"
#include "tests/profiler/builtins/scalar_types.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler::builtins {
namespace {

struct Mode {
  const char* suffix;
  mpfr_rnd_t to_float;           // without a suffix to nearest
  double (*to_integer)(double);  // without a suffix towards zero
  int hardware;
};

double to_nearest(double x) { return std::nearbyint(x); }
double towards_zero(double x) { return std::trunc(x); }
double up(double x) { return std::ceil(x); }
double down(double x) { return std::floor(x); }

constexpr Mode modes[] = {{"", MPFR_RNDN, towards_zero, FE_TONEAREST},
                          {"_rte", MPFR_RNDN, to_nearest, FE_TONEAREST},
                          {"_rtz", MPFR_RNDZ, towards_zero, FE_TOWARDZERO},
                          {"_rtp", MPFR_RNDU, up, FE_UPWARD},
                          {"_rtn", MPFR_RNDD, down, FE_DOWNWARD}};

// The value that the conversion must give; none where OpenCL leaves it open.
template <class To, class From>
std::optional<To> converted(From x, bool saturated, const Mode& mode) {
  using L = std::numeric_limits<To>;
  if constexpr (std::is_integral_v<To> && std::is_integral_v<From>) {
    if (!saturated) return static_cast<To>(x);
    if (std::cmp_less(x, L::min())) return L::min();
    if (std::cmp_greater(x, L::max())) return L::max();
    return static_cast<To>(x);
  } else if constexpr (std::is_integral_v<To>) {
    if (std::isnan(x)) return saturated ? std::optional<To>(0) : std::nullopt;
    const double whole = mode.to_integer(x);
    // 2^digits: the first number above, exactly.
    if (whole >= std::ldexp(1.0, L::digits)) return saturated ? std::optional<To>(L::max()) : std::nullopt;
    if (whole < static_cast<double>(L::min())) return saturated ? std::optional<To>(L::min()) : std::nullopt;
    return static_cast<To>(whole);
  } else if constexpr (std::is_integral_v<From>) {
    mpfr_t rounded;
    mpfr_init2(rounded, L::digits);
    if constexpr (std::is_signed_v<From>)
      mpfr_set_sj(rounded, x, mode.to_float);
    else
      mpfr_set_uj(rounded, x, mode.to_float);
    const auto result = static_cast<To>(mpfr_get_d(rounded, MPFR_RNDN));
    mpfr_clear(rounded);
    return result;
  } else {
    const volatile From source = x;
    std::fesetround(mode.hardware);
    const volatile To result = static_cast<To>(source);
    std::fesetround(FE_TONEAREST);
    return result;
  }
}

// Every conversion from one type into vectors of one width, 1 for scalars; the results lie one behind
// another.
std::string program(std::string_view from, std::uint32_t width) {
  const std::string n = width == 1 ? "" : std::to_string(width);
  std::string text = fmt::format(
      "kernel void measured(global void* results, global const {0}* xs, int which) {{\n"
      "  const size_t i = get_global_id(0);\n  const {0}{1} x = {2};\n  switch (which) {{\n",
      from, n, width == 1 ? "xs[i]" : fmt::format("vload{}(i, xs)", n));
  int which = 0;
  for_all_types([&]<class To>(To) {
    for (const bool saturated : {false, true})
      for (const Mode& mode : modes) {
        if (saturated && !std::is_integral_v<To>) continue;
        const std::string value =
            fmt::format("convert_{}{}{}{}(x)", name_of<To>(), n, saturated ? "_sat" : "", mode.suffix);
        const std::string target = fmt::format("(global {}*)results", name_of<To>());
        text += fmt::format("    case {}: {}; break;\n", which++,
                            width == 1 ? fmt::format("({})[i] = {}", target, value)
                                       : fmt::format("vstore{}({}, i, {})", n, value, target));
      }
  });
  return text + "  }\n}\n";
}

template <class T>
bool same(T a, T b) {
  if constexpr (std::is_floating_point_v<T>)
    return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
  else
    return a == b;
}

template <class To, class From>
void expect_converted(const Executable& executable, int which, std::vector<From>& xs, std::uint32_t width,
                      bool saturated, const Mode& mode) {
  std::vector<To> results(xs.size());
  run_launch(executable, line_of(xs.size() / width, 32),
             {buffer_of(results), buffer_of(xs), scalar_of(which)});
  int failures = 0;
  for (std::size_t i = 0; i < xs.size() && failures < 3; ++i) {
    const std::optional<To> expected = converted<To>(xs[i], saturated, mode);
    if (!expected || same(results[i], *expected)) continue;
    ++failures;
    ADD_FAILURE() << fmt::format("convert_{}{}{}{}({} {}) = {}, not {}", name_of<To>(), width,
                                 saturated ? "_sat" : "", mode.suffix, name_of<From>(), xs[i], results[i],
                                 *expected);
  }
}

template <class From>
void expect_conversions_from(std::uint32_t width) {
  Random random;
  std::vector<From> xs = values_of<From>(random);
  const auto executable = compile_kernel(program(name_of<From>(), width), "measured", TraceMode::none);
  int which = 0;
  for_all_types([&]<class To>(To) {
    for (const bool saturated : {false, true})
      for (const Mode& mode : modes)
        if (!saturated || std::is_integral_v<To>)
          expect_converted<To>(*executable, which++, xs, width, saturated, mode);
  });
}

TEST(Conversions, OfScalars) {
  for_all_types([]<class From>(From) { expect_conversions_from<From>(1); });
}

TEST(Conversions, OfVectors) {
  for_all_types([]<class From>(From) { expect_conversions_from<From>(3); });
}

}  // namespace
}  // namespace warpgrain::profiler::builtins
