// cl_khr_int64_base_atomics and cl_khr_int64_extended_atomics, as the instructions that devices have for
// them: clang takes 64-bit atomics of this target for calls of a library.

#include "profiler/builtins/vectors.h"

#define WARPGRAIN_ATOMIC(T, space, ptx_space, name, operation, operand) \
  WARPGRAIN_BUILTIN T atom_##name(volatile space T* place, T value) {   \
    T old;                                                              \
    __asm__ volatile("atom." ptx_space "." operation " %0, [%1], %2;"   \
                     : "=l"(old)                                        \
                     : "l"(place), "l"(operand)                         \
                     : "memory");                                       \
    return old;                                                         \
  }
#define WARPGRAIN_ATOMICS(T, type, space, ptx_space)                                      \
  WARPGRAIN_ATOMIC(T, space, ptx_space, add, "add.u64", value)                            \
  WARPGRAIN_ATOMIC(T, space, ptx_space, sub, "add.u64", -value)                           \
  WARPGRAIN_ATOMIC(T, space, ptx_space, xchg, "exch.b64", value)                          \
  WARPGRAIN_ATOMIC(T, space, ptx_space, min, "min." type, value)                          \
  WARPGRAIN_ATOMIC(T, space, ptx_space, max, "max." type, value)                          \
  WARPGRAIN_ATOMIC(T, space, ptx_space, and, "and.b64", value)                            \
  WARPGRAIN_ATOMIC(T, space, ptx_space, or, "or.b64", value)                              \
  WARPGRAIN_ATOMIC(T, space, ptx_space, xor, "xor.b64", value)                            \
  WARPGRAIN_BUILTIN T atom_inc(volatile space T* place) { return atom_add(place, (T)1); } \
  WARPGRAIN_BUILTIN T atom_dec(volatile space T* place) { return atom_sub(place, (T)1); } \
  WARPGRAIN_BUILTIN T atom_cmpxchg(volatile space T* place, T expected, T value) {        \
    T old;                                                                                \
    __asm__ volatile("atom." ptx_space ".cas.b64 %0, [%1], %2, %3;"                       \
                     : "=l"(old)                                                          \
                     : "l"(place), "l"(expected), "l"(value)                              \
                     : "memory");                                                         \
    return old;                                                                           \
  }

WARPGRAIN_ATOMICS(long, "s64", global, "global")
WARPGRAIN_ATOMICS(ulong, "u64", global, "global")
WARPGRAIN_ATOMICS(long, "s64", local, "shared")
WARPGRAIN_ATOMICS(ulong, "u64", local, "shared")
