// cl_khr_fp16: functions of halfs. Those of floats, rounded once more, are well within the two and more units
// in the last place that OpenCL allows.

#include "profiler/builtins/vectors.h"

#pragma OPENCL EXTENSION cl_khr_fp16 : enable

#define WARPGRAIN_HALF_X(f)                                      \
  WARPGRAIN_BUILTIN half f(half x) { return (half)f((float)x); } \
  WARPGRAIN_VECTORS_X(f, half)
#define WARPGRAIN_HALF_XY(f)                                                       \
  WARPGRAIN_BUILTIN half f(half x, half y) { return (half)f((float)x, (float)y); } \
  WARPGRAIN_VECTORS_XY(f, half, half)
#define WARPGRAIN_HALF_XI(f)                                               \
  WARPGRAIN_BUILTIN half f(half x, int n) { return (half)f((float)x, n); } \
  WARPGRAIN_VECTORS_XY(f, half, int)
// f(x, y, z)
#define WARPGRAIN_HALF_XYZ(f, expression)                                 \
  WARPGRAIN_BUILTIN half f(half x, half y, half z) { return expression; } \
  WARPGRAIN_BUILTIN half2 f(half2 x, half2 y, half2 z) {                  \
    return (half2)(f(x.x, y.x, z.x), f(x.y, y.y, z.y));                   \
  }                                                                       \
  WARPGRAIN_BUILTIN half3 f(half3 x, half3 y, half3 z) {                  \
    return (half3)(f(x.xy, y.xy, z.xy), f(x.z, y.z, z.z));                \
  }                                                                       \
  WARPGRAIN_BUILTIN half4 f(half4 x, half4 y, half4 z) {                  \
    return (half4)(f(x.lo, y.lo, z.lo), f(x.hi, y.hi, z.hi));             \
  }                                                                       \
  WARPGRAIN_BUILTIN half8 f(half8 x, half8 y, half8 z) {                  \
    return (half8)(f(x.lo, y.lo, z.lo), f(x.hi, y.hi, z.hi));             \
  }                                                                       \
  WARPGRAIN_BUILTIN half16 f(half16 x, half16 y, half16 z) {              \
    return (half16)(f(x.lo, y.lo, z.lo), f(x.hi, y.hi, z.hi));            \
  }

WARPGRAIN_HALF_X(acos)
WARPGRAIN_HALF_X(acosh)
WARPGRAIN_HALF_X(acospi)
WARPGRAIN_HALF_X(asin)
WARPGRAIN_HALF_X(asinh)
WARPGRAIN_HALF_X(asinpi)
WARPGRAIN_HALF_X(atan)
WARPGRAIN_HALF_X(atanh)
WARPGRAIN_HALF_X(atanpi)
WARPGRAIN_HALF_X(cbrt)
WARPGRAIN_HALF_X(ceil)
WARPGRAIN_HALF_X(cos)
WARPGRAIN_HALF_X(cosh)
WARPGRAIN_HALF_X(cospi)
WARPGRAIN_HALF_X(degrees)
WARPGRAIN_HALF_X(erf)
WARPGRAIN_HALF_X(erfc)
WARPGRAIN_HALF_X(exp)
WARPGRAIN_HALF_X(exp10)
WARPGRAIN_HALF_X(exp2)
WARPGRAIN_HALF_X(expm1)
WARPGRAIN_HALF_X(fabs)
WARPGRAIN_HALF_X(floor)
WARPGRAIN_HALF_X(lgamma)
WARPGRAIN_HALF_X(log)
WARPGRAIN_HALF_X(log10)
WARPGRAIN_HALF_X(log1p)
WARPGRAIN_HALF_X(log2)
WARPGRAIN_HALF_X(logb)
WARPGRAIN_HALF_X(radians)
WARPGRAIN_HALF_X(rint)
WARPGRAIN_HALF_X(round)
WARPGRAIN_HALF_X(sign)
WARPGRAIN_HALF_X(sin)
WARPGRAIN_HALF_X(sinh)
WARPGRAIN_HALF_X(sinpi)
WARPGRAIN_HALF_X(tan)
WARPGRAIN_HALF_X(tanh)
WARPGRAIN_HALF_X(tanpi)
WARPGRAIN_HALF_X(tgamma)
WARPGRAIN_HALF_X(trunc)
WARPGRAIN_HALF_XY(atan2)
WARPGRAIN_HALF_XY(atan2pi)
WARPGRAIN_HALF_XY(copysign)
WARPGRAIN_HALF_XY(fdim)
WARPGRAIN_HALF_XY(fmax)
WARPGRAIN_HALF_XY(fmin)
WARPGRAIN_HALF_XY(fmod)
WARPGRAIN_HALF_XY(hypot)
WARPGRAIN_HALF_XY(max)
WARPGRAIN_HALF_XY(maxmag)
WARPGRAIN_HALF_XY(min)
WARPGRAIN_HALF_XY(minmag)
WARPGRAIN_HALF_XY(pow)
WARPGRAIN_HALF_XY(powr)
WARPGRAIN_HALF_XY(remainder)
WARPGRAIN_HALF_XY(step)
WARPGRAIN_HALF_XI(ldexp)
WARPGRAIN_HALF_XI(pown)
WARPGRAIN_HALF_XI(rootn)
WARPGRAIN_HALF_XYZ(fma, __builtin_fmaf16(x, y, z))
WARPGRAIN_HALF_XYZ(mad, x* y + z)
WARPGRAIN_HALF_XYZ(clamp, min(max(x, y), z))
WARPGRAIN_HALF_XYZ(mix, (half)mix((float)x, (float)y, (float)z))
WARPGRAIN_HALF_XYZ(smoothstep, (half)smoothstep((float)x, (float)y, (float)z))

// Away from zero the bit pattern grows.
WARPGRAIN_BUILTIN half nextafter(half x, half y) {
  if (isnan((float)x)) return x;
  if (isnan((float)y) || x == y) return y;
  const short bits = as_short(x);
  if (x == 0) return as_half((short)(1 | (as_short(y) & (short)0x8000)));
  return as_half((short)(bits + ((x < y) == (x > 0) ? 1 : -1)));
}
WARPGRAIN_VECTORS_XY(nextafter, half, half)

#define WARPGRAIN_HALF_LDEXPS(width) \
  WARPGRAIN_BUILTIN half##width ldexp(half##width x, int n) { return ldexp(x, (int##width)n); }
WARPGRAIN_HALF_LDEXPS(2)
WARPGRAIN_HALF_LDEXPS(3)
WARPGRAIN_HALF_LDEXPS(4)
WARPGRAIN_HALF_LDEXPS(8)
WARPGRAIN_HALF_LDEXPS(16)

// Sums of products are built in float.
#define WARPGRAIN_HALF_GEOMETRY(width)                                                           \
  WARPGRAIN_BUILTIN half dot(half##width x, half##width y) {                                     \
    return (half)dot(convert_float##width(x), convert_float##width(y));                          \
  }                                                                                              \
  WARPGRAIN_BUILTIN half length(half##width x) { return (half)length(convert_float##width(x)); } \
  WARPGRAIN_BUILTIN half distance(half##width x, half##width y) {                                \
    return (half)distance(convert_float##width(x), convert_float##width(y));                     \
  }                                                                                              \
  WARPGRAIN_BUILTIN half##width normalize(half##width x) {                                       \
    return convert_half##width(normalize(convert_float##width(x)));                              \
  }
WARPGRAIN_HALF_GEOMETRY()
WARPGRAIN_HALF_GEOMETRY(2)
WARPGRAIN_HALF_GEOMETRY(3)
WARPGRAIN_HALF_GEOMETRY(4)
WARPGRAIN_BUILTIN half3 cross(half3 x, half3 y) {
  return convert_half3(cross(convert_float3(x), convert_float3(y)));
}
WARPGRAIN_BUILTIN half4 cross(half4 x, half4 y) {
  return convert_half4(cross(convert_float4(x), convert_float4(y)));
}

// Of vectors, -1 where it holds.
#define WARPGRAIN_X(T) T x
#define WARPGRAIN_X_AND_Y(T) T x, T y
#define WARPGRAIN_HALF_TESTS(f, arguments, condition)                \
  WARPGRAIN_BUILTIN int f(arguments(half)) { return condition; }     \
  WARPGRAIN_BUILTIN short2 f(arguments(half2)) { return condition; } \
  WARPGRAIN_BUILTIN short3 f(arguments(half3)) { return condition; } \
  WARPGRAIN_BUILTIN short4 f(arguments(half4)) { return condition; } \
  WARPGRAIN_BUILTIN short8 f(arguments(half8)) { return condition; } \
  WARPGRAIN_BUILTIN short16 f(arguments(half16)) { return condition; }
WARPGRAIN_HALF_TESTS(isequal, WARPGRAIN_X_AND_Y, x == y)
WARPGRAIN_HALF_TESTS(isnotequal, WARPGRAIN_X_AND_Y, x != y)
WARPGRAIN_HALF_TESTS(isgreater, WARPGRAIN_X_AND_Y, x > y)
WARPGRAIN_HALF_TESTS(isgreaterequal, WARPGRAIN_X_AND_Y, x >= y)
WARPGRAIN_HALF_TESTS(isless, WARPGRAIN_X_AND_Y, x < y)
WARPGRAIN_HALF_TESTS(islessequal, WARPGRAIN_X_AND_Y, x <= y)
WARPGRAIN_HALF_TESTS(islessgreater, WARPGRAIN_X_AND_Y, (x < y) | (x > y))
WARPGRAIN_HALF_TESTS(isordered, WARPGRAIN_X_AND_Y, (x == x) & (y == y))
WARPGRAIN_HALF_TESTS(isunordered, WARPGRAIN_X_AND_Y, (x != x) | (y != y))
WARPGRAIN_HALF_TESTS(isnan, WARPGRAIN_X, x != x)

// By the bits.
#define WARPGRAIN_HALF_CLASSES(f, condition) \
  WARPGRAIN_BUILTIN int f(half h) {          \
    const short x = as_short(h);             \
    return condition;                        \
  }                                          \
  WARPGRAIN_BUILTIN short2 f(half2 h) {      \
    const short2 x = as_short2(h);           \
    return condition;                        \
  }                                          \
  WARPGRAIN_BUILTIN short3 f(half3 h) {      \
    const short3 x = as_short3(h);           \
    return condition;                        \
  }                                          \
  WARPGRAIN_BUILTIN short4 f(half4 h) {      \
    const short4 x = as_short4(h);           \
    return condition;                        \
  }                                          \
  WARPGRAIN_BUILTIN short8 f(half8 h) {      \
    const short8 x = as_short8(h);           \
    return condition;                        \
  }                                          \
  WARPGRAIN_BUILTIN short16 f(half16 h) {    \
    const short16 x = as_short16(h);         \
    return condition;                        \
  }
WARPGRAIN_HALF_CLASSES(isfinite, (x & (short)0x7c00) != (short)0x7c00)
WARPGRAIN_HALF_CLASSES(isinf, (x & (short)0x7fff) == (short)0x7c00)
WARPGRAIN_HALF_CLASSES(isnormal, ((x & (short)0x7c00) != (short)0x7c00) & ((x & (short)0x7c00) != (short)0))
WARPGRAIN_HALF_CLASSES(signbit, x < (short)0)

#define WARPGRAIN_HALF_SELECT(I, width)                                            \
  WARPGRAIN_BUILTIN half##width select(half##width x, half##width y, I##width c) { \
    return as_half##width(select(as_short##width(x), as_short##width(y), c));      \
  }
#define WARPGRAIN_HALF_SELECTS(width)                                                             \
  WARPGRAIN_HALF_SELECT(short, width)                                                             \
  WARPGRAIN_HALF_SELECT(ushort, width)                                                            \
  WARPGRAIN_BUILTIN half##width bitselect(half##width x, half##width y, half##width c) {          \
    return as_half##width(bitselect(as_short##width(x), as_short##width(y), as_short##width(c))); \
  }
WARPGRAIN_HALF_SELECTS()
WARPGRAIN_HALF_SELECTS(2)
WARPGRAIN_HALF_SELECTS(3)
WARPGRAIN_HALF_SELECTS(4)
WARPGRAIN_HALF_SELECTS(8)
WARPGRAIN_HALF_SELECTS(16)
