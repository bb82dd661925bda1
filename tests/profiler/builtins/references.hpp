#pragma once
// Exact results by MPFR.

#include "tests/profiler/builtins/math_function.hpp"

namespace warpgrain::profiler::builtins {

// MPFR's function of one, two or three numbers as a Reference.
template <auto function>
void of_x(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x);
  function(result, x.get(), MPFR_RNDN);
}

template <auto function>
void of_xy(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x), y(a.y);
  function(result, x.get(), y.get(), MPFR_RNDN);
}

// A double, which the result is: of a computation that is exact in double or in float.
template <auto function>
void exactly(mpfr_ptr result, const Arguments& a) {
  mpfr_set_d(result, function(a), MPFR_RNDN);
}

void rsqrt(mpfr_ptr result, const Arguments& a);
void powr(mpfr_ptr result, const Arguments& a);
void reciprocal(mpfr_ptr result, const Arguments& a);
// x y + z; the last of its bits says whether there were more, so that rounding it once more rounds right.
void fused_multiply_add(mpfr_ptr result, const Arguments& a);

}  // namespace warpgrain::profiler::builtins
