// Remainders of floats by long division of their mantissas, a bit of the quotient at a time: exact.

#include "profiler/builtins/vectors.h"

// A positive finite x as mantissa 2^exponent, the mantissa from 2^23 to 2^24.
WARPGRAIN_INLINE uint warpgrain_mantissa(float x, int* exponent) {
  const uint bits = as_uint(x);
  const uint mantissa = bits & 0x007fffff;
  if (bits >= 0x00800000) {
    *exponent = (int)(bits >> 23) - 150;
    return mantissa | 0x00800000;
  }
  const int shift = (int)clz(mantissa) - 8;
  *exponent = -149 - shift;
  return mantissa << shift;
}

// The rest of |x| / |y|, and the last bits of the quotient: towards zero, or to the nearest, where the rest
// may be negative. For finite x and y that are not zero.
WARPGRAIN_INLINE float warpgrain_rest(float x, float y, bool nearest, uint* quotient) {
  int x_exponent, y_exponent;
  uint rest = warpgrain_mantissa(fabs(x), &x_exponent);
  uint divisor = warpgrain_mantissa(fabs(y), &y_exponent);
  *quotient = 0;
  if (x_exponent < y_exponent - 1) return fabs(x);
  if (x_exponent < y_exponent) {
    divisor <<= 1;
    y_exponent = x_exponent;
  }
  for (int step = x_exponent - y_exponent;; --step) {
    *quotient <<= 1;
    if (rest >= divisor) {
      rest -= divisor;
      *quotient |= 1;
    }
    if (step == 0) break;
    rest <<= 1;
  }
  int signed_rest = (int)rest;
  if (nearest && (2 * rest > divisor || (2 * rest == divisor && (*quotient & 1)))) {
    signed_rest -= (int)divisor;
    *quotient += 1;
  }
  return ldexp((float)signed_rest, y_exponent);
}

// x itself where y is infinite, NaN where there is no remainder.
WARPGRAIN_INLINE bool warpgrain_has_no_rest(float x, float y, float* result) {
  *result = isnan(x) || isnan(y) || isinf(x) || y == 0.0f ? NAN : x;
  return isnan(*result) || isinf(y) || x == 0.0f;
}

WARPGRAIN_BUILTIN float fmod(float x, float y) {
  float result;
  uint quotient;
  if (warpgrain_has_no_rest(x, y, &result)) return result;
  return copysign(warpgrain_rest(x, y, false, &quotient), x);
}

WARPGRAIN_INLINE float warpgrain_remquo(float x, float y, int* quotient) {
  float result;
  uint bits;
  *quotient = 0;
  if (warpgrain_has_no_rest(x, y, &result)) return result;
  const float rest = warpgrain_rest(x, y, true, &bits);
  *quotient = signbit(x) == signbit(y) ? (int)(bits & 127) : -(int)(bits & 127);
  return rest == 0.0f ? copysign(0.0f, x) : x < 0.0f ? -rest : rest;
}

WARPGRAIN_BUILTIN float remainder(float x, float y) {
  int quotient;
  return warpgrain_remquo(x, y, &quotient);
}

WARPGRAIN_VECTORS_XY(fmod, float, float)
WARPGRAIN_VECTORS_XY(remainder, float, float)
WARPGRAIN_SECONDS_OF_XY(remquo, warpgrain_remquo, float)
