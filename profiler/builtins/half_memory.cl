// Stores of halves rounded up or down. libclc loses what is smaller than half of the smallest half.

#include "profiler/builtins/vectors.h"

#define WARPGRAIN_OF_COMPONENTS(f, T, U)                                     \
  WARPGRAIN_INLINE U##2 f(T##2 x) { return (U##2)(f(x.x), f(x.y)); }         \
  WARPGRAIN_INLINE U##3 f(T##3 x) { return (U##3)(f(x.x), f(x.y), f(x.z)); } \
  WARPGRAIN_INLINE U##4 f(T##4 x) { return (U##4)(f(x.lo), f(x.hi)); }       \
  WARPGRAIN_INLINE U##8 f(T##8 x) { return (U##8)(f(x.lo), f(x.hi)); }       \
  WARPGRAIN_INLINE U##16 f(T##16 x) { return (U##16)(f(x.lo), f(x.hi)); }

// The nearest half, or the next one above where that is below x: away from zero the bit pattern grows.
#define WARPGRAIN_DIRECTED_HALF(T)                                                            \
  WARPGRAIN_INLINE ushort warpgrain_half_rtp(T x) {                                           \
    ushort bits;                                                                              \
    vstore_half_rte(x, 0, (half*)&bits);                                                      \
    if (!(vload_half(0, (half*)&bits) < x)) return bits;                                      \
    return (bits & 0x8000) ? bits - 1 : bits + 1;                                             \
  }                                                                                           \
  WARPGRAIN_INLINE ushort warpgrain_half_rtn(T x) { return warpgrain_half_rtp(-x) ^ 0x8000; } \
  WARPGRAIN_OF_COMPONENTS(warpgrain_half_rtp, T, ushort)                                      \
  WARPGRAIN_OF_COMPONENTS(warpgrain_half_rtn, T, ushort)

WARPGRAIN_DIRECTED_HALF(float)
WARPGRAIN_DIRECTED_HALF(double)

#define WARPGRAIN_STORE_WIDTH(T, mode, space, n)                                  \
  WARPGRAIN_BUILTIN void vstore_half##n##mode(T##n x, size_t i, space half* p) {  \
    vstore##n(warpgrain_half##mode(x), i, (space ushort*)p);                      \
  }                                                                               \
  WARPGRAIN_BUILTIN void vstorea_half##n##mode(T##n x, size_t i, space half* p) { \
    ((space ushort##n*)p)[i] = warpgrain_half##mode(x);                           \
  }

#define WARPGRAIN_STORES(T, mode, space)                                   \
  WARPGRAIN_BUILTIN void vstore_half##mode(T x, size_t i, space half* p) { \
    ((space ushort*)p)[i] = warpgrain_half##mode(x);                       \
  }                                                                        \
  WARPGRAIN_STORE_WIDTH(T, mode, space, 2)                                 \
  WARPGRAIN_STORE_WIDTH(T, mode, space, 3)                                 \
  WARPGRAIN_STORE_WIDTH(T, mode, space, 4)                                 \
  WARPGRAIN_STORE_WIDTH(T, mode, space, 8)                                 \
  WARPGRAIN_STORE_WIDTH(T, mode, space, 16)

#define WARPGRAIN_STORES_EVERYWHERE(T, mode) \
  WARPGRAIN_STORES(T, mode, private)         \
  WARPGRAIN_STORES(T, mode, global)          \
  WARPGRAIN_STORES(T, mode, local)

WARPGRAIN_STORES_EVERYWHERE(float, _rtp)
WARPGRAIN_STORES_EVERYWHERE(float, _rtn)
WARPGRAIN_STORES_EVERYWHERE(double, _rtp)
WARPGRAIN_STORES_EVERYWHERE(double, _rtn)
