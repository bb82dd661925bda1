// Powers and roots of floats: 2^(y log2(x)), the logarithm in two parts, since its error counts y times.

#include "profiler/builtins/exponential.h"
#include "profiler/builtins/logarithm.h"

// log2(x) = high + low, to about 2^-29, for x from 0 to infinity. log(1 + f) by u = f / (2 + f), which is
// computed to twice the digits: log((1 + u) / (1 - u)) = 2 u + 2 u^3 / 3 + ...
WARPGRAIN_INLINE float warpgrain_log2_in_parts(float x, float* low) {
  *low = 0.0f;
  if (x == 0.0f) return -INFINITY;
  if (!(x < INFINITY)) return x;
  float k;
  const float f = warpgrain_log_parts(x, &k);
  const float divisor = 2.0f + f, lost = f - (divisor - 2.0f);
  const float reciprocal = 1.0f / divisor;
  const float u = f * reciprocal;
  const float rest_of_u = fma(-u, lost, fma(-u, divisor, f)) * reciprocal;
  const float log_high = 2.0f * u;
  const float log_low = fma(u * u * u, warpgrain_atanh_polynomial(u * u), 2.0f * rest_of_u);
  const float scaled = log_high * 0x1.715476p+0f;
  const float rest =
      fma(log_low, 0x1.715476p+0f, fma(log_high, 0x1.4ae0c0p-26f, fma(log_high, 0x1.715476p+0f, -scaled)));
  const float sum = k + scaled;
  const float sum_low = ((k - sum) + scaled) + rest;
  const float high = sum + sum_low;
  *low = (sum - high) + sum_low;
  return high;
}

// x^(y + y_low) for x from 0 to infinity; NaN where 0 meets infinity.
WARPGRAIN_INLINE float warpgrain_power(float x, float y, float y_low) {
  float low;
  const float high = warpgrain_log2_in_parts(x, &low);
  const float t = y * high;
  const float rest = fma(y_low, high, fma(y, low, fma(y, high, -t)));
  // Beyond, the result is zero or infinite, and `rest` may be the difference of infinities.
  return warpgrain_exp2_of_sum(t, fabs(t) < 1000.0f ? rest : 0.0f, 0);
}

WARPGRAIN_BUILTIN float powr(float x, float y) {
  return x < 0.0f || isnan(y) ? NAN : warpgrain_power(fabs(x), y, 0.0f);
}

WARPGRAIN_BUILTIN float pow(float x, float y) {
  const float a = fabs(x);
  if (x == 1.0f || y == 0.0f || (a == 1.0f && isinf(y))) return 1.0f;
  const bool whole = trunc(y) == y;
  // From 2^24 on all numbers are even.
  const bool odd = whole && fabs(y) < 0x1p24f && ((int)y & 1);
  if ((x < 0.0f && x > -INFINITY && !whole) || isnan(y)) return NAN;
  const float magnitude = warpgrain_power(a, y, 0.0f);
  return odd ? copysign(magnitude, x) : magnitude;
}

WARPGRAIN_BUILTIN float pown(float x, int n) {
  if (n == 0) return 1.0f;
  const float y = (float)n;
  const float magnitude = warpgrain_power(fabs(x), y, (float)((long)n - (long)y));
  return (n & 1) ? copysign(magnitude, x) : magnitude;
}

WARPGRAIN_BUILTIN float rootn(float x, int n) {
  if (n == 0 || (x < 0.0f && !(n & 1))) return NAN;
  const float divisor = (float)n, divisor_low = (float)((long)n - (long)divisor);
  const float y = 1.0f / divisor;
  const float y_low = fma(-y, divisor_low, fma(-y, divisor, 1.0f)) * y;
  const float magnitude = warpgrain_power(fabs(x), y, y_low);
  return (n & 1) ? copysign(magnitude, x) : magnitude;
}

WARPGRAIN_BUILTIN float half_powr(float x, float y) { return powr(x, y); }

WARPGRAIN_VECTORS_XY(powr, float, float)
WARPGRAIN_VECTORS_XY(pow, float, float)
WARPGRAIN_VECTORS_XY(pown, float, int)
WARPGRAIN_VECTORS_XY(rootn, float, int)
WARPGRAIN_VECTORS_XY(half_powr, float, float)
