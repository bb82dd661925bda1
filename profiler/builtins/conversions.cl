// Conversions with a rounding mode in which a float takes part: single instructions, where libclc corrects a
// rounded result and misses at the ends of the integers. From float to integer they saturate, NaN gives zero.

#include "profiler/builtins/vectors.h"

// Scalars and vectors of convert_TO<suffix>(FROM) by `instruction`.
#define WARPGRAIN_CONVERSION(TO, FROM, suffix, instruction)                    \
  WARPGRAIN_BUILTIN TO convert_##TO##suffix(FROM x) { return instruction(x); } \
  WARPGRAIN_BUILTIN TO##2 convert_##TO##2##suffix(FROM##2 x) {                 \
    return (TO##2)(instruction(x.x), instruction(x.y));                        \
  }                                                                            \
  WARPGRAIN_BUILTIN TO##3 convert_##TO##3##suffix(FROM##3 x) {                 \
    return (TO##3)(instruction(x.x), instruction(x.y), instruction(x.z));      \
  }                                                                            \
  WARPGRAIN_CONVERSION_OF_HALVES(TO, FROM, suffix, 2, 4)                       \
  WARPGRAIN_CONVERSION_OF_HALVES(TO, FROM, suffix, 4, 8)                       \
  WARPGRAIN_CONVERSION_OF_HALVES(TO, FROM, suffix, 8, 16)

#define WARPGRAIN_CONVERSION_OF_HALVES(TO, FROM, suffix, half_width, width)                             \
  WARPGRAIN_BUILTIN TO##width convert_##TO##width##suffix(FROM##width x) {                              \
    return (TO##width)(convert_##TO##half_width##suffix(x.lo), convert_##TO##half_width##suffix(x.hi)); \
  }

#define WARPGRAIN_TO_FLOAT(TO, FROM, instruction)                    \
  WARPGRAIN_CONVERSION(TO, FROM, _rte, warpgrain_##instruction##_rn) \
  WARPGRAIN_CONVERSION(TO, FROM, _rtz, warpgrain_##instruction##_rz) \
  WARPGRAIN_CONVERSION(TO, FROM, _rtp, warpgrain_##instruction##_rp) \
  WARPGRAIN_CONVERSION(TO, FROM, _rtn, warpgrain_##instruction##_rm)

#define WARPGRAIN_TO_INTEGER(TO, FROM, instruction)                      \
  WARPGRAIN_TO_FLOAT(TO, FROM, instruction)                              \
  WARPGRAIN_CONVERSION(TO, FROM, _sat, warpgrain_##instruction##_rz)     \
  WARPGRAIN_CONVERSION(TO, FROM, _sat_rte, warpgrain_##instruction##_rn) \
  WARPGRAIN_CONVERSION(TO, FROM, _sat_rtz, warpgrain_##instruction##_rz) \
  WARPGRAIN_CONVERSION(TO, FROM, _sat_rtp, warpgrain_##instruction##_rp) \
  WARPGRAIN_CONVERSION(TO, FROM, _sat_rtn, warpgrain_##instruction##_rm)

// One instruction in each rounding mode: i is empty for results that are floats, "i" for integers.
#define WARPGRAIN_CVT(TO, FROM, name, i, types, out, in)         \
  WARPGRAIN_CVT_MODE(TO, FROM, name##_rn, "rn" i types, out, in) \
  WARPGRAIN_CVT_MODE(TO, FROM, name##_rz, "rz" i types, out, in) \
  WARPGRAIN_CVT_MODE(TO, FROM, name##_rp, "rp" i types, out, in) \
  WARPGRAIN_CVT_MODE(TO, FROM, name##_rm, "rm" i types, out, in)

#define WARPGRAIN_CVT_MODE(TO, FROM, name, modifiers, out, in) \
  WARPGRAIN_INLINE TO warpgrain_##name(FROM x) {               \
    TO y;                                                      \
    __asm__("cvt." modifiers " %0, %1;" : out(y) : in(x));     \
    return y;                                                  \
  }

WARPGRAIN_CVT(float, int, i2f, "", ".f32.s32", "=f", "r")
WARPGRAIN_CVT(float, uint, ui2f, "", ".f32.u32", "=f", "r")
WARPGRAIN_CVT(float, long, ll2f, "", ".f32.s64", "=f", "l")
WARPGRAIN_CVT(float, ulong, ull2f, "", ".f32.u64", "=f", "l")
WARPGRAIN_CVT(float, double, d2f, "", ".f32.f64", "=f", "d")
WARPGRAIN_CVT(double, long, ll2d, "", ".f64.s64", "=d", "l")
WARPGRAIN_CVT(double, ulong, ull2d, "", ".f64.u64", "=d", "l")
WARPGRAIN_CVT(int, float, f2i, "i", ".s32.f32", "=r", "f")
WARPGRAIN_CVT(uint, float, f2ui, "i", ".u32.f32", "=r", "f")
WARPGRAIN_CVT(long, float, f2ll, "i", ".s64.f32", "=l", "f")
WARPGRAIN_CVT(ulong, float, f2ull, "i", ".u64.f32", "=l", "f")
WARPGRAIN_CVT(int, double, d2i, "i", ".s32.f64", "=r", "d")
WARPGRAIN_CVT(uint, double, d2ui, "i", ".u32.f64", "=r", "d")
WARPGRAIN_CVT(long, double, d2ll, "i", ".s64.f64", "=l", "d")
WARPGRAIN_CVT(ulong, double, d2ull, "i", ".u64.f64", "=l", "d")

WARPGRAIN_TO_FLOAT(float, int, i2f)
WARPGRAIN_TO_FLOAT(float, uint, ui2f)
WARPGRAIN_TO_FLOAT(float, long, ll2f)
WARPGRAIN_TO_FLOAT(float, ulong, ull2f)
WARPGRAIN_TO_FLOAT(float, double, d2f)
WARPGRAIN_TO_FLOAT(double, long, ll2d)
WARPGRAIN_TO_FLOAT(double, ulong, ull2d)
WARPGRAIN_TO_INTEGER(int, float, f2i)
WARPGRAIN_TO_INTEGER(uint, float, f2ui)
WARPGRAIN_TO_INTEGER(long, float, f2ll)
WARPGRAIN_TO_INTEGER(ulong, float, f2ull)
WARPGRAIN_TO_INTEGER(int, double, d2i)
WARPGRAIN_TO_INTEGER(uint, double, d2ui)
WARPGRAIN_TO_INTEGER(long, double, d2ll)
WARPGRAIN_TO_INTEGER(ulong, double, d2ull)
