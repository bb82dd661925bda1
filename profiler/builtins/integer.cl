// Integer functions that come out wrong of libclc or of LLVM's code generator.

#include "profiler/builtins/vectors.h"

// The sum of the product's 128 bits and z, cut to what fits.
WARPGRAIN_BUILTIN long mad_sat(long x, long y, long z) {
  const ulong product = (ulong)x * (ulong)y, low = product + (ulong)z;
  const long high = mul_hi(x, y) + (z >> 63) + (low < product ? 1 : 0);
  if (high == (long)low >> 63) return (long)low;
  return high < 0 ? LONG_MIN : LONG_MAX;
}

// As a funnel shift, which LLVM makes of the shorter form, amounts of 64 and more give zero on NVPTX.
WARPGRAIN_BUILTIN ulong rotate(ulong x, ulong y) {
  const ulong amount = y & 63;
  return (x << amount) + ((x >> 1) >> (63 - amount));
}

WARPGRAIN_BUILTIN long rotate(long x, long y) { return (long)rotate((ulong)x, (ulong)y); }

WARPGRAIN_VECTORS_XY(rotate, ulong, ulong)
WARPGRAIN_VECTORS_XY(rotate, long, long)

WARPGRAIN_BUILTIN long2 mad_sat(long2 x, long2 y, long2 z) {
  return (long2)(mad_sat(x.x, y.x, z.x), mad_sat(x.y, y.y, z.y));
}
WARPGRAIN_BUILTIN long3 mad_sat(long3 x, long3 y, long3 z) {
  return (long3)(mad_sat(x.xy, y.xy, z.xy), mad_sat(x.z, y.z, z.z));
}
WARPGRAIN_BUILTIN long4 mad_sat(long4 x, long4 y, long4 z) {
  return (long4)(mad_sat(x.lo, y.lo, z.lo), mad_sat(x.hi, y.hi, z.hi));
}
WARPGRAIN_BUILTIN long8 mad_sat(long8 x, long8 y, long8 z) {
  return (long8)(mad_sat(x.lo, y.lo, z.lo), mad_sat(x.hi, y.hi, z.hi));
}
WARPGRAIN_BUILTIN long16 mad_sat(long16 x, long16 y, long16 z) {
  return (long16)(mad_sat(x.lo, y.lo, z.lo), mad_sat(x.hi, y.hi, z.hi));
}
