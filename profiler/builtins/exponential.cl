// Powers of 2, 10 and e, and the hyperbolic functions made of them.

#include "profiler/builtins/exponential.h"

WARPGRAIN_BUILTIN float exp2(float x) { return __nvvm_ex2_approx_f(x); }
WARPGRAIN_BUILTIN float exp(float x) { return warpgrain_exp(x, 0); }
WARPGRAIN_BUILTIN float exp10(float x) {
  return warpgrain_power_of_base(x, 0x1.a934f0p+1f, 0x1.2f346ep-24f, 0);
}
WARPGRAIN_BUILTIN float half_exp2(float x) { return exp2(x); }
WARPGRAIN_BUILTIN float half_exp(float x) { return exp(x); }
WARPGRAIN_BUILTIN float half_exp10(float x) { return exp10(x); }

// e^x / 4 + e^-x / 4, doubled: near the end e^x is too large where half of it is not.
WARPGRAIN_BUILTIN float cosh(float x) {
  const float quarter = warpgrain_exp(fabs(x), -2);
  return 2.0f * quarter + 0.125f / quarter;
}

WARPGRAIN_BUILTIN float sinh(float x) {
  const float a = fabs(x), square = x * x;
  if (a < 1.0f) return fma(x * square, warpgrain_sinh_polynomial(square), x);
  const float quarter = warpgrain_exp(a, -2);
  return copysign(2.0f * quarter - 0.125f / quarter, x);
}

// 1 - 2 / (e^2x + 1)
WARPGRAIN_BUILTIN float tanh(float x) {
  const float a = fabs(x), square = x * x;
  const float small = fma(a * square, warpgrain_tanh_polynomial(square), a);
  return copysign(a < 0.6f ? small : 1.0f - 2.0f / (warpgrain_exp(2.0f * a, 0) + 1.0f), x);
}

WARPGRAIN_VECTORS_X(exp2, float)
WARPGRAIN_VECTORS_X(exp, float)
WARPGRAIN_VECTORS_X(exp10, float)
WARPGRAIN_VECTORS_X(half_exp2, float)
WARPGRAIN_VECTORS_X(half_exp, float)
WARPGRAIN_VECTORS_X(half_exp10, float)
WARPGRAIN_VECTORS_X(cosh, float)
WARPGRAIN_VECTORS_X(sinh, float)
WARPGRAIN_VECTORS_X(tanh, float)

// x = n ln 2 + r: 2^n (e^r - 1) + (2^n - 1).
WARPGRAIN_BUILTIN double expm1(double x) {
  if (x > 710.0) return INFINITY;
  if (x < -40.0) return -1.0;
  const double n = rint(x * 0x1.71547652b82fep+0);
  const double r = fma(n, -0x1.abc9e3b39803fp-56, fma(n, -0x1.62e42fefa39efp-1, x));
  const double p = fma(r * r, fma(r, warpgrain_expm1_polynomial(r), 0.5), r);
  // At n = 1024 only half of the factor is a number.
  const double half_factor = as_double((long)(n + 1022.0) << 52);
  if (n == 0.0) return x == 0.0 ? x : p;
  return 2.0 * fma(half_factor, p, half_factor - 0.5);
}

WARPGRAIN_VECTORS_X(expm1, double)
