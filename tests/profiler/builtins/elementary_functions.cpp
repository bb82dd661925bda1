// Powers, logarithms, angles, and the special functions.

#include <cmath>

#include "tests/profiler/builtins/references.hpp"

namespace warpgrain::profiler::builtins {
namespace {

void cosine_of_sincos(mpfr_ptr result, const Arguments& a) { of_x<mpfr_cos>(result, a); }

void log_gamma(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x);
  int sign = 0;
  mpfr_lgamma(result, &sign, x.get(), MPFR_RNDN);
}

double sign_of_gamma(const Arguments& a) {
  if (a.x >= 0) return std::signbit(a.x) ? -1 : 1;
  return std::fmod(std::floor(a.x), 2) == 0 ? 1 : -1;
}

bool has_sign_of_gamma(const Arguments& a) {
  return std::isfinite(a.x) && (a.x > 0 || a.x != std::floor(a.x));
}

// The error of a sum that nearly cancels: near its zeros lgamma is only as good as its terms.
double near_zeros_of_lgamma(const Arguments& a) { return a.x < 0 ? std::ldexp(8.0, -a.digits) : 0; }

void pown(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x);
  mpfr_pow_si(result, x.get(), a.n, MPFR_RNDN);
}

void rootn(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x);
  mpfr_rootn_si(result, x.get(), a.n, MPFR_RNDN);
}

const MathFunction elementary_table[] = {
    {"acos", "acos(x)", Inputs::x, 4, 4, of_x<mpfr_acos>, {-1, 1}},
    {"acosh", "acosh(x)", Inputs::x, 4, 4, of_x<mpfr_acosh>, {1, 20}},
    {"acospi", "acospi(x)", Inputs::x, 5, 5, of_x<mpfr_acospi>, {-1, 1}},
    {"asin", "asin(x)", Inputs::x, 4, 4, of_x<mpfr_asin>, {-1, 1}},
    {"asinh", "asinh(x)", Inputs::x, 4, 4, of_x<mpfr_asinh>},
    {"asinpi", "asinpi(x)", Inputs::x, 5, 5, of_x<mpfr_asinpi>, {-1, 1}},
    {"atan", "atan(x)", Inputs::x, 5, 5, of_x<mpfr_atan>},
    {"atan2", "atan2(x, y)", Inputs::xy, 6, 6, of_xy<mpfr_atan2>},
    {"atanh", "atanh(x)", Inputs::x, 5, 5, of_x<mpfr_atanh>, {-1, 1}},
    {"atanpi", "atanpi(x)", Inputs::x, 5, 5, of_x<mpfr_atanpi>},
    {"atan2pi", "atan2pi(x, y)", Inputs::xy, 6, 6, of_xy<mpfr_atan2pi>},
    {"cbrt", "cbrt(x)", Inputs::x, 2, 2, of_x<mpfr_cbrt>},
    {"cos", "cos(x)", Inputs::x, 4, 4, of_x<mpfr_cos>, {-100, 100}},
    {"cosh", "cosh(x)", Inputs::x, 4, 4, of_x<mpfr_cosh>, {-90, 90, 7.9}},
    {"cospi", "cospi(x)", Inputs::x, 4, 4, of_x<mpfr_cospi>, {.signed_zero = false}},
    {"erf", "erf(x)", Inputs::x, 16, 16, of_x<mpfr_erf>, {-6, 6}},
    {"erfc", "erfc(x)", Inputs::x, 16, 16, of_x<mpfr_erfc>, {-6, 27}},
    {"exp", "exp(x)", Inputs::x, 3, 3, of_x<mpfr_exp>, {-105, 90, 7.5}},
    {"exp10", "exp10(x)", Inputs::x, 3, 3, of_x<mpfr_exp10>, {-46, 39, 7.5}},
    {"exp2", "exp2(x)", Inputs::x, 3, 3, of_x<mpfr_exp2>, {-150, 129, 7.5}},
    {"expm1", "expm1(x)", Inputs::x, 3, 3, of_x<mpfr_expm1>, {-20, 90, 7.9}},
    {"hypot", "hypot(x, y)", Inputs::xy, 4, 4, of_xy<mpfr_hypot>},
    {"lgamma",
     "lgamma(x)",
     Inputs::x,
     16,
     16,
     log_gamma,
     {.from = -20,
      .to = 60,
      .absolute = near_zeros_of_lgamma,
      .signed_zero = false,
      .limit_text = "ours: 16, or 8 epsilon where x < 0"}},
    {"lgamma_r",
     "({ I s; lgamma_r(x, &s); })",
     Inputs::x,
     16,
     16,
     log_gamma,
     {.from = -20,
      .to = 60,
      .absolute = near_zeros_of_lgamma,
      .signed_zero = false,
      .limit_text = "ours: 16, or 8 epsilon where x < 0"}},
    {"lgamma_r, sign",
     "({ I s; lgamma_r(x, &s); AS_T(s); })",
     Inputs::x,
     exact,
     exact,
     exactly<sign_of_gamma>,
     {.from = -20, .to = 60, .defined = has_sign_of_gamma}},
    {"log", "log(x)", Inputs::x, 3, 3, of_x<mpfr_log>, {0, 10}},
    {"log10", "log10(x)", Inputs::x, 3, 3, of_x<mpfr_log10>, {0, 10}},
    {"log1p", "log1p(x)", Inputs::x, 2, 2, of_x<mpfr_log1p>, {-1, 3}},
    {"log2", "log2(x)", Inputs::x, 3, 3, of_x<mpfr_log2>, {0, 10}},
    {"pow", "pow(x, y)", Inputs::xy, 16, 16, of_xy<mpfr_pow>, {0, 20}},
    {"pown", "pown(x, n)", Inputs::xn, 16, 16, pown},
    {"powr", "powr(x, y)", Inputs::xy, 16, 16, powr, {0, 20}},
    {"rootn", "rootn(x, n)", Inputs::xn, 16, 16, rootn},
    {"rsqrt", "rsqrt(x)", Inputs::x, 2, 2, rsqrt, {0, 10}},
    {"sin", "sin(x)", Inputs::x, 4, 4, of_x<mpfr_sin>, {-100, 100}},
    {"sincos, sine", "({ T c; sincos(x, &c); })", Inputs::x, 4, 4, of_x<mpfr_sin>, {-100, 100}},
    {"sincos, cosine", "({ T c; sincos(x, &c); c; })", Inputs::x, 4, 4, cosine_of_sincos, {-100, 100}},
    {"sinh", "sinh(x)", Inputs::x, 4, 4, of_x<mpfr_sinh>, {-90, 90, 7.9}},
    {"sinpi", "sinpi(x)", Inputs::x, 4, 4, of_x<mpfr_sinpi>, {.signed_zero = false}},
    {"sqrt", "sqrt(x)", Inputs::x, 3, exact, of_x<mpfr_sqrt>, {0, 10}},
    {"tan", "tan(x)", Inputs::x, 5, 5, of_x<mpfr_tan>, {-100, 100}},
    {"tanh", "tanh(x)", Inputs::x, 5, 5, of_x<mpfr_tanh>},
    {"tanpi", "tanpi(x)", Inputs::x, 6, 6, of_x<mpfr_tanpi>, {.signed_zero = false}},
    {"tgamma", "tgamma(x)", Inputs::x, 16, 16, of_x<mpfr_gamma>, {-45, 36, 4.5}},
};

}  // namespace

std::span<const MathFunction> elementary_functions() { return elementary_table; }

}  // namespace warpgrain::profiler::builtins
