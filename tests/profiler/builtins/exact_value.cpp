#include "tests/profiler/builtins/exact_value.hpp"

#include <algorithm>
#include <cmath>

namespace warpgrain::profiler::builtins {
namespace {

constexpr double wrong = std::numeric_limits<double>::infinity();

// log2 of the unit in the last place of T at a finite value.
template <class T>
mpfr_exp_t exponent_of_unit(const Exact& x) {
  using Limits = std::numeric_limits<T>;
  const mpfr_exp_t least = Limits::min_exponent - Limits::digits;
  if (mpfr_zero_p(x.get())) return least;
  return std::max(least, std::min<mpfr_exp_t>(mpfr_get_exp(x.get()), Limits::max_exponent) - Limits::digits);
}

}  // namespace

template <>
float correctly_rounded<float>(const Exact& x) {
  return mpfr_get_flt(x.get(), MPFR_RNDN);
}

template <>
double correctly_rounded<double>(const Exact& x) {
  return mpfr_get_d(x.get(), MPFR_RNDN);
}

template <class T>
double ulp_error(const Exact& x, T got, bool signed_zero, double least_unit) {
  const mpfr_srcptr value = x.get();
  if (mpfr_nan_p(value)) return std::isnan(got) ? 0 : wrong;
  if (std::isnan(got)) return wrong;
  if (mpfr_inf_p(value)) return std::isinf(got) && std::signbit(got) == (mpfr_sgn(value) < 0) ? 0 : wrong;
  if (mpfr_zero_p(value) && got == 0)
    return signed_zero && std::signbit(got) != (mpfr_signbit(value) != 0) ? wrong : 0;

  if (std::isinf(got) && got == correctly_rounded<T>(x)) return 0;
  Exact error(got);
  if (std::isinf(got))
    mpfr_set_si_2exp(error.get(), got > 0 ? 1 : -1, std::numeric_limits<T>::max_exponent, MPFR_RNDN);
  mpfr_sub(error.get(), error.get(), value, MPFR_RNDU);
  Exact unit(least_unit);
  Exact last_place(1);
  mpfr_mul_2si(last_place.get(), last_place.get(), exponent_of_unit<T>(x), MPFR_RNDN);
  mpfr_max(unit.get(), unit.get(), last_place.get(), MPFR_RNDN);
  mpfr_div(error.get(), error.get(), unit.get(), MPFR_RNDU);
  return std::abs(mpfr_get_d(error.get(), MPFR_RNDA));
}

template double ulp_error<float>(const Exact&, float, bool, double);
template double ulp_error<double>(const Exact&, double, bool, double);

}  // namespace warpgrain::profiler::builtins
