// Arithmetic, and the functions that take numbers apart and put them together: all exact or correctly
// rounded.

#include <cmath>

#include "tests/profiler/builtins/references.hpp"

namespace warpgrain::profiler::builtins {
namespace {

constexpr int largest_int = std::numeric_limits<int>::max();
constexpr int smallest_int = std::numeric_limits<int>::min();

bool is_float(const Arguments& a) { return a.digits == std::numeric_limits<float>::digits; }
bool finite(const Arguments& a) { return std::isfinite(a.x); }
bool ordered_quotient(const Arguments& a) { return std::isfinite(a.x) && a.y != 0 && !std::isnan(a.y); }

double copysign(const Arguments& a) { return std::copysign(a.x, a.y); }
double fabs(const Arguments& a) { return std::fabs(a.x); }
double fmax(const Arguments& a) { return std::fmax(a.x, a.y); }
double fmin(const Arguments& a) { return std::fmin(a.x, a.y); }

double maxmag(const Arguments& a) {
  if (std::abs(a.x) > std::abs(a.y)) return a.x;
  return std::abs(a.y) > std::abs(a.x) ? a.y : std::fmax(a.x, a.y);
}

double minmag(const Arguments& a) {
  if (std::abs(a.x) < std::abs(a.y)) return a.x;
  return std::abs(a.y) < std::abs(a.x) ? a.y : std::fmin(a.x, a.y);
}

double frexp(const Arguments& a) {
  int exponent = 0;
  return std::frexp(a.x, &exponent);
}

double exponent_of_frexp(const Arguments& a) {
  int exponent = 0;
  std::frexp(a.x, &exponent);
  return exponent;
}

double modf(const Arguments& a) {
  double whole = 0;
  return std::modf(a.x, &whole);
}

double whole_of_modf(const Arguments& a) { return std::trunc(a.x); }

// min(x - floor(x), the greatest number below 1), section 6.12.2; the difference is rounded once.
void fract(mpfr_ptr result, const Arguments& a) {
  if (!std::isfinite(a.x) || a.x == 0) {
    mpfr_set_d(result, std::isnan(a.x) ? a.x : std::copysign(0.0, a.x), MPFR_RNDN);
    return;
  }
  const Exact x(a.x);
  mpfr_floor(result, x.get());
  mpfr_sub(result, x.get(), result, MPFR_RNDN);
  const double largest = 1 - std::ldexp(1.0, -a.digits);
  // What lies above it rounds to it or to 1.
  if (mpfr_cmp_d(result, largest) > 0) mpfr_set_d(result, largest, MPFR_RNDN);
}

double ilogb(const Arguments& a) {
  if (a.x == 0) return smallest_int;            // FP_ILOGB0
  if (!std::isfinite(a.x)) return largest_int;  // FP_ILOGBNAN, and INT_MAX for infinity
  return std::ilogb(a.x);
}

void ldexp(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x);
  mpfr_mul_2si(result, x.get(), a.n, MPFR_RNDN);
}

double nextafter(const Arguments& a) {
  return is_float(a) ? std::nextafter(static_cast<float>(a.x), static_cast<float>(a.y))
                     : std::nextafter(a.x, a.y);
}

void remquo(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x), y(a.y);
  Exact remainder;
  long quotient = 0;
  mpfr_remquo(remainder.get(), &quotient, x.get(), y.get(), MPFR_RNDN);
  mpfr_set_si(result, quotient % 128, MPFR_RNDN);
}

void round_even(mpfr_ptr result, const Arguments& a) { of_x<mpfr_rint_roundeven>(result, a); }
const MathFunction other_math_table[] = {
    {"x + y", "x + y", Inputs::xy, exact, exact, of_xy<mpfr_add>},
    {"x - y", "x - y", Inputs::xy, exact, exact, of_xy<mpfr_sub>},
    {"x * y", "x * y", Inputs::xy, exact, exact, of_xy<mpfr_mul>},
    {"x / y", "x / y", Inputs::xy, 2.5, exact, of_xy<mpfr_div>},
    {"1 / x", "1 / x", Inputs::x, 2.5, exact, reciprocal},
    {"ceil", "ceil(x)", Inputs::x, exact, exact, of_x<mpfr_rint_ceil>},
    {"copysign", "copysign(x, y)", Inputs::xy, exact, exact, exactly<copysign>},
    {"fabs", "fabs(x)", Inputs::x, exact, exact, exactly<fabs>},
    {"fdim", "fdim(x, y)", Inputs::xy, exact, exact, of_xy<mpfr_dim>},
    {"floor", "floor(x)", Inputs::x, exact, exact, of_x<mpfr_rint_floor>},
    {"fma", "fma(x, y, z)", Inputs::xyz, exact, exact, fused_multiply_add},
    {"fmax", "fmax(x, y)", Inputs::xy, exact, exact, exactly<fmax>, {.signed_zero = false}},
    {"fmin", "fmin(x, y)", Inputs::xy, exact, exact, exactly<fmin>, {.signed_zero = false}},
    {"fmod", "fmod(x, y)", Inputs::xy, exact, exact, of_xy<mpfr_fmod>},
    {"fract", "({ T w; fract(x, &w); })", Inputs::x, exact, exact, fract},
    {"fract, floor", "({ T w; fract(x, &w); w; })", Inputs::x, exact, exact, of_x<mpfr_rint_floor>},
    {"frexp", "({ I e; frexp(x, &e); })", Inputs::x, exact, exact, exactly<frexp>},
    {"frexp, exponent",
     "({ I e; frexp(x, &e); AS_T(e); })",
     Inputs::x,
     exact,
     exact,
     exactly<exponent_of_frexp>,
     {.defined = finite}},
    {"ilogb", "AS_T(ilogb(x))", Inputs::x, exact, exact, exactly<ilogb>},
    {"ldexp", "ldexp(x, n)", Inputs::xn, exact, exact, ldexp},
    {"logb", "logb(x)", Inputs::x, exact, exact, exactly<[](const Arguments& a) { return std::logb(a.x); }>},
    {"mad",
     "mad(x, y, z)",
     Inputs::xyz,
     exact,
     exact,
     fused_multiply_add,
     {.limit_text = "any (ours: as fma)"}},
    {"maxmag", "maxmag(x, y)", Inputs::xy, exact, exact, exactly<maxmag>, {.signed_zero = false}},
    {"minmag", "minmag(x, y)", Inputs::xy, exact, exact, exactly<minmag>, {.signed_zero = false}},
    {"modf", "({ T w; modf(x, &w); })", Inputs::x, exact, exact, exactly<modf>},
    {"modf, whole part", "({ T w; modf(x, &w); w; })", Inputs::x, exact, exact, exactly<whole_of_modf>},
    {"nextafter", "nextafter(x, y)", Inputs::xy, exact, exact, exactly<nextafter>},
    {"remainder", "remainder(x, y)", Inputs::xy, exact, exact, of_xy<mpfr_remainder>},
    {"remquo", "({ I q; remquo(x, y, &q); })", Inputs::xy, exact, exact, of_xy<mpfr_remainder>},
    {"remquo, quotient",
     "({ I q; remquo(x, y, &q); AS_T(q); })",
     Inputs::xy,
     exact,
     exact,
     remquo,
     {.defined = ordered_quotient}},
    {"rint", "rint(x)", Inputs::x, exact, exact, round_even},
    {"round", "round(x)", Inputs::x, exact, exact, of_x<mpfr_rint_round>},
    {"trunc", "trunc(x)", Inputs::x, exact, exact, of_x<mpfr_rint_trunc>},
};

}  // namespace

std::span<const MathFunction> other_math_functions() { return other_math_table; }

}  // namespace warpgrain::profiler::builtins
