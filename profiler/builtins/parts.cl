// Functions that take numbers apart and put them together; nothing is lost, subnormal numbers included.

#include "profiler/builtins/vectors.h"

// min(x - floor(x), the greatest number below one); zeros and infinities give zero with their sign.
WARPGRAIN_INLINE float warpgrain_fract(float x, float* whole) {
  *whole = floor(x);
  if (isnan(x)) return x;
  return x == 0.0f || isinf(x) ? copysign(0.0f, x) : fmin(x - *whole, 0x1.fffffep-1f);
}

WARPGRAIN_INLINE double warpgrain_fract(double x, double* whole) {
  *whole = floor(x);
  if (isnan(x)) return x;
  return x == 0.0 || isinf(x) ? copysign(0.0, x) : fmin(x - *whole, 0x1.fffffffffffffp-1);
}

// x 2^n: the exponent is put together in integers. Where the result is subnormal it is made 2^64 times too
// large, so that one multiplication rounds it.
WARPGRAIN_BUILTIN float ldexp(float x, int n) {
  if (x == 0.0f || isinf(x) || isnan(x)) return x;
  const bool subnormal = fabs(x) < 0x1p-126f;
  const int bits = as_int(subnormal ? x * 0x1p24f : x);
  const int shift = clamp(n, -2000, 2000) - (subnormal ? 24 : 0);
  const int exponent = ((bits >> 23) & 0xff) + shift;
  const int rest = bits & 0x807fffff;
  if (exponent >= 0xff) return copysign(INFINITY, x);
  if (exponent > 0) return as_float(rest | (exponent << 23));
  return as_float(rest | (max(exponent + 64, 1) << 23)) * 0x1p-64f;
}

WARPGRAIN_BUILTIN double ldexp(double x, int n) {
  if (x == 0.0 || isinf(x) || isnan(x)) return x;
  const bool subnormal = fabs(x) < 0x1p-1022;
  const long bits = as_long(subnormal ? x * 0x1p54 : x);
  const int shift = clamp(n, -8000, 8000) - (subnormal ? 54 : 0);
  const int exponent = (int)((bits >> 52) & 0x7ff) + shift;
  const long rest = bits & 0x800fffffffffffff;
  if (exponent >= 0x7ff) return copysign((double)INFINITY, x);
  if (exponent > 0) return as_double(rest | ((long)exponent << 52));
  return as_double(rest | ((long)max(exponent + 64, 1) << 52)) * 0x1p-64;
}

// Away from zero the bit pattern grows.
WARPGRAIN_BUILTIN float nextafter(float x, float y) {
  if (isnan(x) || isnan(y)) return NAN;
  if (x == y) return y;
  if (x == 0.0f) return copysign(0x1p-149f, y);
  return as_float(as_int(x) + ((x < y) == (x > 0.0f) ? 1 : -1));
}

WARPGRAIN_BUILTIN double nextafter(double x, double y) {
  if (isnan(x) || isnan(y)) return NAN;
  if (x == y) return y;
  if (x == 0.0) return copysign(0x1p-1074, y);
  return as_double(as_long(x) + ((x < y) == (x > 0.0) ? 1 : -1));
}

WARPGRAIN_SECONDS_OF_X(fract, warpgrain_fract, float, float)
WARPGRAIN_SECONDS_OF_X(fract, warpgrain_fract, double, double)
WARPGRAIN_VECTORS_XY(ldexp, float, int)
WARPGRAIN_VECTORS_XY(ldexp, double, int)
WARPGRAIN_VECTORS_XY(nextafter, float, float)
WARPGRAIN_VECTORS_XY(nextafter, double, double)

// One exponent for all components.
#define WARPGRAIN_LDEXP_OF_SCALAR(T, width) \
  WARPGRAIN_BUILTIN T##width ldexp(T##width x, int n) { return ldexp(x, (int##width)n); }
#define WARPGRAIN_LDEXPS_OF_SCALAR(T) \
  WARPGRAIN_LDEXP_OF_SCALAR(T, 2)     \
  WARPGRAIN_LDEXP_OF_SCALAR(T, 3)     \
  WARPGRAIN_LDEXP_OF_SCALAR(T, 4)     \
  WARPGRAIN_LDEXP_OF_SCALAR(T, 8)     \
  WARPGRAIN_LDEXP_OF_SCALAR(T, 16)
WARPGRAIN_LDEXPS_OF_SCALAR(float)
WARPGRAIN_LDEXPS_OF_SCALAR(double)
