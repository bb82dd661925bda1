// Logarithms of floats: k log(2) + log(1 + f). The approximate instruction is too far off near one, where
// only its absolute error is bounded.

#include "profiler/builtins/logarithm.h"

WARPGRAIN_INLINE float warpgrain_log1p(float f) {
  return fma(f * f, fma(f, warpgrain_log1p_polynomial(f), -0.5f), f);
}

// -infinity of zero, NaN of what is negative, infinity and NaN of themselves.
WARPGRAIN_INLINE float warpgrain_log_checked(float x, float result) {
  if (x > 0.0f && x < INFINITY) return result;
  return x == 0.0f ? -INFINITY : x < 0.0f ? NAN : x;
}

WARPGRAIN_BUILTIN float log(float x) {
  float k;
  const float f = warpgrain_log_parts(x, &k);
  return warpgrain_log_checked(x, fma(k, M_LN2_F, warpgrain_log1p(f)));
}

WARPGRAIN_BUILTIN float log2(float x) {
  float k;
  const float f = warpgrain_log_parts(x, &k);
  return warpgrain_log_checked(x, fma(warpgrain_log1p(f), M_LOG2E_F, k));
}

WARPGRAIN_BUILTIN float log10(float x) {
  float k;
  const float f = warpgrain_log_parts(x, &k);
  return warpgrain_log_checked(x, fma(k, 0x1.344136p-2f, warpgrain_log1p(f) * M_LOG10E_F));
}

WARPGRAIN_BUILTIN float half_log(float x) { return log(x); }
WARPGRAIN_BUILTIN float half_log2(float x) { return log2(x); }
WARPGRAIN_BUILTIN float half_log10(float x) { return log10(x); }

WARPGRAIN_VECTORS_X(log, float)
WARPGRAIN_VECTORS_X(log2, float)
WARPGRAIN_VECTORS_X(log10, float)
WARPGRAIN_VECTORS_X(half_log, float)
WARPGRAIN_VECTORS_X(half_log2, float)
WARPGRAIN_VECTORS_X(half_log10, float)
