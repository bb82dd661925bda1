#pragma once
// x = n pi / 2 + r, r from -pi / 4 to pi / 4. Small angles: pi / 2 in three parts, of which the first leaves
// an exact difference (W. J. Cody and W. Waite, Software Manual for the Elementary Functions, 1980). Large
// ones: x times those bits of 2 / pi that matter, in integers (M. H. Payne and R. N. Hanek, SIGNUM Newsletter
// 18, 1983).

#include "profiler/builtins/polynomials.h"

// 64 bits of 2 / pi from behind bit `start` on; start may be negative down to -64.
WARPGRAIN_INLINE ulong warpgrain_bits_of_two_over_pi(int start) {
  const int position = start + 64, word = position >> 6, shift = position & 63;
  const ulong high = warpgrain_two_over_pi[word] << shift;
  return shift == 0 ? high : high | (warpgrain_two_over_pi[word + 1] >> (64 - shift));
}

// The last two bits of n. Infinities and NaN give NaN.
WARPGRAIN_INLINE int warpgrain_reduce_angle(float x, float* r) {
  if (fabs(x) < 65536.0f) {
    const int n = __nvvm_f2i_rn(x * M_2_PI_F);
    const float whole = (float)n;
    *r = fma(whole, 0x1.ee59dap-50f, fma(whole, -0x1.4442d2p-24f, fma(whole, -0x1.921fb4p+0f, x)));
    return n;
  }
  const uint bits = as_uint(x) & 0x7fffffff;
  if (bits >= 0x7f800000) {
    *r = NAN;
    return 0;
  }
  // |x| = m 2^e: what is above bit e - 2 of 2 / pi makes multiples of 4.
  const ulong m = (bits & 0x007fffff) | 0x00800000;
  const int start = (int)(bits >> 23) - 150 - 2;
  const ulong product = m * warpgrain_bits_of_two_over_pi(start) +
                        ((m * (warpgrain_bits_of_two_over_pi(start + 64) >> 32)) >> 32);
  const int n = (int)((product + (1UL << 61)) >> 62);
  const float reduced = (float)((double)(long)(product << 2) * 0x1.921fb54442d18p-64);
  *r = x < 0.0f ? -reduced : reduced;
  return x < 0.0f ? -n : n;
}

// The same in double, r in two parts.
WARPGRAIN_INLINE int warpgrain_reduce_angle(double x, double* r, double* r_low) {
  if (fabs(x) < 1048576.0) {
    const double n = rint(x * 0x1.45f306dc9c883p-1);
    const double first = fma(n, -0x1.921fb54442d18p+0, x);
    const double product = n * -0x1.1a62633145c07p-54;
    const double high = first + product;
    const double in_first = high - product, in_product = high - in_first;
    const double lost = (first - in_first) + (product - in_product);
    const double low = lost + fma(n, 0x1.f1976b7ed8fbcp-110, fma(n, -0x1.1a62633145c07p-54, -product));
    *r = n == 0.0 ? x : high;
    *r_low = n == 0.0 ? 0.0 : low;
    return (int)n;
  }
  const ulong bits = as_ulong(x) & 0x7fffffffffffffff;
  *r_low = 0.0;
  if (bits >= 0x7ff0000000000000) {
    *r = NAN;
    return 0;
  }
  const ulong m = (bits & 0x000fffffffffffff) | 0x0010000000000000;
  const int start = (int)(bits >> 52) - 1075 - 2;
  const ulong second = warpgrain_bits_of_two_over_pi(start + 64),
              third = warpgrain_bits_of_two_over_pi(start + 128);
  const ulong low = m * third;
  const ulong middle = m * second + mul_hi(m, third);
  const ulong high =
      m * warpgrain_bits_of_two_over_pi(start) + mul_hi(m, second) + (middle < m * second ? 1 : 0);
  const int n = (int)((high + (1UL << 61)) >> 62);
  // The fraction to the nearest whole number, 128 bits behind the point, and its absolute value.
  ulong upper = (high << 2) | (middle >> 62), lower = (middle << 2) | (low >> 62);
  const bool negative = (long)upper < 0;
  if (negative) {
    lower = -lower;
    upper = ~upper + (lower == 0 ? 1 : 0);
  }
  const int zeros = upper != 0 ? (int)clz(upper) : 64 + (int)clz(lower);
  if (zeros >= 64) {
    upper = lower << (zeros - 64);
    lower = 0;
  } else if (zeros > 0) {
    upper = (upper << zeros) | (lower >> (64 - zeros));
    lower <<= zeros;
  }
  const double unit = as_double((long)(1023 - zeros) << 52);
  const double fraction = (double)(upper >> 11) * 0x1p-53 * unit;
  const double fraction_low = (double)(((upper & 0x7ff) << 53) | (lower >> 11)) * 0x1p-117 * unit;
  const double product = fraction * 0x1.921fb54442d18p+0;
  const double rest = fma(fraction, 0x1.921fb54442d18p+0, -product) +
                      fma(fraction, 0x1.1a62633145c07p-54, fraction_low * 0x1.921fb54442d18p+0);
  const bool flip = negative != (x < 0.0);
  *r = flip ? -product : product;
  *r_low = flip ? -rest : rest;
  return x < 0.0 ? -n : n;
}
