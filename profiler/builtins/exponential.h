#pragma once
// e^x in float as devices do it: one approximate power of two, of what is left when the exponent's whole part
// is taken off, and a scale put together from that part.

#include "profiler/builtins/polynomials.h"

// y 2^n for n from -252 to 254: two factors, of which only the last can round.
WARPGRAIN_INLINE float warpgrain_scaled(float y, int n) {
  const int first = n >> 1;
  return y * as_float((first + 127) << 23) * as_float((n - first + 127) << 23);
}

// 2^(whole and fraction of t) 2^shift, where t = th + tl. What does not fit becomes infinity or zero.
WARPGRAIN_INLINE float warpgrain_exp2_of_sum(float th, float tl, int shift) {
  // In a sum with 1.5 2^23 the last place is that of the units.
  const float shifted = fmin(fmax(th, -200.0f), 200.0f) + 12582912.0f;
  const float whole = shifted - 12582912.0f;
  return warpgrain_scaled(__nvvm_ex2_approx_f((th - whole) + tl), as_int(shifted) - 0x4b400000 + shift);
}

// (high + low)^x with logarithms to base 2 in two parts, both of the same sign: infinity stays infinity.
WARPGRAIN_INLINE float warpgrain_power_of_base(float x, float log2_high, float log2_low, int shift) {
  const float shifted = fmin(fmax(x * log2_high, -200.0f), 200.0f) + 12582912.0f;
  const float whole = shifted - 12582912.0f;
  const float rest = fma(x, log2_low, fma(x, log2_high, -whole));
  return warpgrain_scaled(__nvvm_ex2_approx_f(rest), as_int(shifted) - 0x4b400000 + shift);
}

// e^x 2^shift
WARPGRAIN_INLINE float warpgrain_exp(float x, int shift) {
  return warpgrain_power_of_base(x, 0x1.715476p+0f, 0x1.4ae0c0p-26f, shift);
}
