#pragma once
// A float as 2^k (1 + f), f from -1/3 to 1/3.

#include "profiler/builtins/polynomials.h"

// For positive finite x.
WARPGRAIN_INLINE float warpgrain_log_parts(float x, float* k) {
  const bool subnormal = x < 0x1p-126f;
  const int bits = as_int(subnormal ? x * 0x1p23f : x);
  const int offset = (bits - 0x3f2aaaab) & 0xff800000;
  *k = (float)(offset >> 23) - (subnormal ? 23.0f : 0.0f);
  return as_float(bits - offset) - 1.0f;
}
