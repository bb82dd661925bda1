#include "tests/profiler/builtins/references.hpp"

#include <cmath>

namespace warpgrain::profiler::builtins {

void rsqrt(mpfr_ptr result, const Arguments& a) {
  of_x<mpfr_rec_sqrt>(result, a);
  if (a.x == 0 && std::signbit(a.x)) mpfr_set_inf(result, -1);
}

// powr(1, NaN) is NaN, section 7.5.1.
void powr(mpfr_ptr result, const Arguments& a) {
  of_xy<mpfr_powr>(result, a);
  if (std::isnan(a.y)) mpfr_set_nan(result);
}

void reciprocal(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x);
  mpfr_ui_div(result, 1, x.get(), MPFR_RNDN);
}

void fused_multiply_add(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x), y(a.y), z(a.z);
  const bool inexact = mpfr_fma(result, x.get(), y.get(), z.get(), MPFR_RNDZ) != 0;
  if (!inexact) return;
  // Round to odd (S. Boldo and G. Melquiond, IEEE Transactions on Computers 57, 2008).
  const mpfr_prec_t bits = mpfr_get_prec(result);
  if (mpfr_min_prec(result) == bits) return;
  if (mpfr_sgn(result) > 0)
    mpfr_nextabove(result);
  else
    mpfr_nextbelow(result);
}

}  // namespace warpgrain::profiler::builtins
