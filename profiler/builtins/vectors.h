#pragma once
// How built-in functions are defined: for scalars, and from those for vectors of 2, 3, 4, 8 and 16.

#pragma OPENCL FP_CONTRACT OFF

#define WARPGRAIN_INLINE static inline __attribute__((overloadable, always_inline))
#define WARPGRAIN_BUILTIN __attribute__((overloadable))

// f(x)
#define WARPGRAIN_VECTORS_X(f, T)                                             \
  WARPGRAIN_BUILTIN T##2 f(T##2 x) { return (T##2)(f(x.x), f(x.y)); }         \
  WARPGRAIN_BUILTIN T##3 f(T##3 x) { return (T##3)(f(x.x), f(x.y), f(x.z)); } \
  WARPGRAIN_BUILTIN T##4 f(T##4 x) { return (T##4)(f(x.lo), f(x.hi)); }       \
  WARPGRAIN_BUILTIN T##8 f(T##8 x) { return (T##8)(f(x.lo), f(x.hi)); }       \
  WARPGRAIN_BUILTIN T##16 f(T##16 x) { return (T##16)(f(x.lo), f(x.hi)); }

// f(x, y)
#define WARPGRAIN_VECTORS_XY(f, T, U)                                                                \
  WARPGRAIN_BUILTIN T##2 f(T##2 x, U##2 y) { return (T##2)(f(x.x, y.x), f(x.y, y.y)); }              \
  WARPGRAIN_BUILTIN T##3 f(T##3 x, U##3 y) { return (T##3)(f(x.x, y.x), f(x.y, y.y), f(x.z, y.z)); } \
  WARPGRAIN_BUILTIN T##4 f(T##4 x, U##4 y) { return (T##4)(f(x.lo, y.lo), f(x.hi, y.hi)); }          \
  WARPGRAIN_BUILTIN T##8 f(T##8 x, U##8 y) { return (T##8)(f(x.lo, y.lo), f(x.hi, y.hi)); }          \
  WARPGRAIN_BUILTIN T##16 f(T##16 x, U##16 y) { return (T##16)(f(x.lo, y.lo), f(x.hi, y.hi)); }

// f(x, U* second), the scalar function `both(x, U* second)` given; for pointers of each address space.
#define WARPGRAIN_SECOND_OF_X(f, both, T, U, space)                              \
  WARPGRAIN_BUILTIN T f(T x, space U* second) {                                  \
    U s;                                                                         \
    const T first = both(x, &s);                                                 \
    *second = s;                                                                 \
    return first;                                                                \
  }                                                                              \
  WARPGRAIN_BUILTIN T##2 f(T##2 x, space U##2 * second) {                        \
    U s[2];                                                                      \
    const T##2 first = (T##2)(both(x.x, s), both(x.y, s + 1));                   \
    *second = (U##2)(s[0], s[1]);                                                \
    return first;                                                                \
  }                                                                              \
  WARPGRAIN_BUILTIN T##3 f(T##3 x, space U##3 * second) {                        \
    U s[3];                                                                      \
    const T##3 first = (T##3)(both(x.x, s), both(x.y, s + 1), both(x.z, s + 2)); \
    *second = (U##3)(s[0], s[1], s[2]);                                          \
    return first;                                                                \
  }                                                                              \
  WARPGRAIN_HALVES_OF_X(f, T, U, space, 2, 4)                                    \
  WARPGRAIN_HALVES_OF_X(f, T, U, space, 4, 8)                                    \
  WARPGRAIN_HALVES_OF_X(f, T, U, space, 8, 16)

#define WARPGRAIN_HALVES_OF_X(f, T, U, space, half_width, width)      \
  WARPGRAIN_BUILTIN T##width f(T##width x, space U##width* second) {  \
    U##half_width low, high;                                          \
    const T##width first = (T##width)(f(x.lo, &low), f(x.hi, &high)); \
    *second = (U##width)(low, high);                                  \
    return first;                                                     \
  }

#define WARPGRAIN_SECONDS_OF_X(f, both, T, U)   \
  WARPGRAIN_SECOND_OF_X(f, both, T, U, private) \
  WARPGRAIN_SECOND_OF_X(f, both, T, U, global)  \
  WARPGRAIN_SECOND_OF_X(f, both, T, U, local)

// f(x, y, int* second)
#define WARPGRAIN_SECOND_OF_XY(f, both, T, space)                                               \
  WARPGRAIN_BUILTIN T f(T x, T y, space int* second) {                                          \
    int s;                                                                                      \
    const T first = both(x, y, &s);                                                             \
    *second = s;                                                                                \
    return first;                                                                               \
  }                                                                                             \
  WARPGRAIN_BUILTIN T##2 f(T##2 x, T##2 y, space int2* second) {                                \
    int s[2];                                                                                   \
    const T##2 first = (T##2)(both(x.x, y.x, s), both(x.y, y.y, s + 1));                        \
    *second = (int2)(s[0], s[1]);                                                               \
    return first;                                                                               \
  }                                                                                             \
  WARPGRAIN_BUILTIN T##3 f(T##3 x, T##3 y, space int3* second) {                                \
    int s[3];                                                                                   \
    const T##3 first = (T##3)(both(x.x, y.x, s), both(x.y, y.y, s + 1), both(x.z, y.z, s + 2)); \
    *second = (int3)(s[0], s[1], s[2]);                                                         \
    return first;                                                                               \
  }                                                                                             \
  WARPGRAIN_HALVES_OF_XY(f, T, space, 2, 4)                                                     \
  WARPGRAIN_HALVES_OF_XY(f, T, space, 4, 8)                                                     \
  WARPGRAIN_HALVES_OF_XY(f, T, space, 8, 16)

#define WARPGRAIN_HALVES_OF_XY(f, T, space, half_width, width)                     \
  WARPGRAIN_BUILTIN T##width f(T##width x, T##width y, space int##width* second) { \
    int##half_width low, high;                                                     \
    const T##width first = (T##width)(f(x.lo, y.lo, &low), f(x.hi, y.hi, &high));  \
    *second = (int##width)(low, high);                                             \
    return first;                                                                  \
  }

#define WARPGRAIN_SECONDS_OF_XY(f, both, T)   \
  WARPGRAIN_SECOND_OF_XY(f, both, T, private) \
  WARPGRAIN_SECOND_OF_XY(f, both, T, global)  \
  WARPGRAIN_SECOND_OF_XY(f, both, T, local)
