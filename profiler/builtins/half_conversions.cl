// cl_khr_fp16: conversions from and to halfs, in every rounding; loads and stores of vectors of halfs.

#include "profiler/builtins/vectors.h"

#pragma OPENCL EXTENSION cl_khr_fp16 : enable

#define WARPGRAIN_CONVERT_VECTORS(convert, suffix, To, From)                          \
  WARPGRAIN_BUILTIN To##2 convert##2##suffix(From##2 x) {                             \
    return (To##2)(convert##suffix(x.x), convert##suffix(x.y));                       \
  }                                                                                   \
  WARPGRAIN_BUILTIN To##3 convert##3##suffix(From##3 x) {                             \
    return (To##3)(convert##suffix(x.x), convert##suffix(x.y), convert##suffix(x.z)); \
  }                                                                                   \
  WARPGRAIN_BUILTIN To##4 convert##4##suffix(From##4 x) {                             \
    return (To##4)(convert##2##suffix(x.lo), convert##2##suffix(x.hi));               \
  }                                                                                   \
  WARPGRAIN_BUILTIN To##8 convert##8##suffix(From##8 x) {                             \
    return (To##8)(convert##4##suffix(x.lo), convert##4##suffix(x.hi));               \
  }                                                                                   \
  WARPGRAIN_BUILTIN To##16 convert##16##suffix(From##16 x) {                          \
    return (To##16)(convert##8##suffix(x.lo), convert##8##suffix(x.hi));              \
  }

// To halfs: one instruction, with its type, the register that holds it and what the value is passed as.
#define WARPGRAIN_TO_HALF(From, suffix, rounding, type, in, Wide)                \
  WARPGRAIN_BUILTIN half convert_half##suffix(From x) {                          \
    ushort bits;                                                                 \
    __asm__("cvt." rounding ".f16." type " %0, %1;" : "=h"(bits) : in((Wide)x)); \
    return as_half(bits);                                                        \
  }                                                                              \
  WARPGRAIN_CONVERT_VECTORS(convert_half, suffix, half, From)
#define WARPGRAIN_TO_HALFS(From, type, in, Wide)      \
  WARPGRAIN_TO_HALF(From, , "rn", type, in, Wide)     \
  WARPGRAIN_TO_HALF(From, _rte, "rn", type, in, Wide) \
  WARPGRAIN_TO_HALF(From, _rtz, "rz", type, in, Wide) \
  WARPGRAIN_TO_HALF(From, _rtp, "rp", type, in, Wide) \
  WARPGRAIN_TO_HALF(From, _rtn, "rm", type, in, Wide)
WARPGRAIN_TO_HALFS(char, "s16", "h", short)
WARPGRAIN_TO_HALFS(uchar, "u16", "h", ushort)
WARPGRAIN_TO_HALFS(short, "s16", "h", short)
WARPGRAIN_TO_HALFS(ushort, "u16", "h", ushort)
WARPGRAIN_TO_HALFS(int, "s32", "r", int)
WARPGRAIN_TO_HALFS(uint, "u32", "r", uint)
WARPGRAIN_TO_HALFS(long, "s64", "l", long)
WARPGRAIN_TO_HALFS(ulong, "u64", "l", ulong)
WARPGRAIN_TO_HALFS(float, "f32", "f", float)
WARPGRAIN_TO_HALFS(double, "f64", "d", double)

// From halfs: a float holds each.
#define WARPGRAIN_FROM_HALF(To, suffix)                                                        \
  WARPGRAIN_BUILTIN To convert_##To##suffix(half x) { return convert_##To##suffix((float)x); } \
  WARPGRAIN_CONVERT_VECTORS(convert_##To, suffix, To, half)
#define WARPGRAIN_FROM_HALFS(To) \
  WARPGRAIN_FROM_HALF(To, )      \
  WARPGRAIN_FROM_HALF(To, _rte)  \
  WARPGRAIN_FROM_HALF(To, _rtz)  \
  WARPGRAIN_FROM_HALF(To, _rtp)  \
  WARPGRAIN_FROM_HALF(To, _rtn)
#define WARPGRAIN_FROM_HALFS_TO_INTEGER(To) \
  WARPGRAIN_FROM_HALFS(To)                  \
  WARPGRAIN_FROM_HALF(To, _sat)             \
  WARPGRAIN_FROM_HALF(To, _sat_rte)         \
  WARPGRAIN_FROM_HALF(To, _sat_rtz)         \
  WARPGRAIN_FROM_HALF(To, _sat_rtp)         \
  WARPGRAIN_FROM_HALF(To, _sat_rtn)
WARPGRAIN_FROM_HALFS_TO_INTEGER(char)
WARPGRAIN_FROM_HALFS_TO_INTEGER(uchar)
WARPGRAIN_FROM_HALFS_TO_INTEGER(short)
WARPGRAIN_FROM_HALFS_TO_INTEGER(ushort)
WARPGRAIN_FROM_HALFS_TO_INTEGER(int)
WARPGRAIN_FROM_HALFS_TO_INTEGER(uint)
WARPGRAIN_FROM_HALFS_TO_INTEGER(long)
WARPGRAIN_FROM_HALFS_TO_INTEGER(ulong)
WARPGRAIN_FROM_HALFS(float)
WARPGRAIN_FROM_HALFS(double)

#define WARPGRAIN_SAME_HALF(suffix)                                 \
  WARPGRAIN_BUILTIN half convert_half##suffix(half x) { return x; } \
  WARPGRAIN_CONVERT_VECTORS(convert_half, suffix, half, half)
WARPGRAIN_SAME_HALF()
WARPGRAIN_SAME_HALF(_rte)
WARPGRAIN_SAME_HALF(_rtz)
WARPGRAIN_SAME_HALF(_rtp)
WARPGRAIN_SAME_HALF(_rtn)

// As vectors of shorts.
#define WARPGRAIN_LOAD_HALFS(width, space)                                             \
  WARPGRAIN_BUILTIN half##width vload##width(size_t offset, const space half* place) { \
    return as_half##width(vload##width(offset, (const space short*)place));            \
  }
#define WARPGRAIN_STORE_HALFS(width, space)                                                   \
  WARPGRAIN_BUILTIN void vstore##width(half##width value, size_t offset, space half* place) { \
    vstore##width(as_short##width(value), offset, (space short*)place);                       \
  }
#define WARPGRAIN_MOVE_HALFS(width)     \
  WARPGRAIN_LOAD_HALFS(width, constant) \
  WARPGRAIN_LOAD_HALFS(width, global)   \
  WARPGRAIN_LOAD_HALFS(width, local)    \
  WARPGRAIN_LOAD_HALFS(width, private)  \
  WARPGRAIN_STORE_HALFS(width, global)  \
  WARPGRAIN_STORE_HALFS(width, local)   \
  WARPGRAIN_STORE_HALFS(width, private)
WARPGRAIN_MOVE_HALFS(2)
WARPGRAIN_MOVE_HALFS(3)
WARPGRAIN_MOVE_HALFS(4)
WARPGRAIN_MOVE_HALFS(8)
WARPGRAIN_MOVE_HALFS(16)
