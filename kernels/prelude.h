// What every kernel file includes first: the dialect of the platform and the layout of the data.
#ifndef WARPGRAIN_PRELUDE_H
#define WARPGRAIN_PRELUDE_H

#if defined(__OPENCL_C_VERSION__)
#include "prelude_opencl.h"
#elif defined(__CUDACC__)
#include "prelude_cuda.h"
#endif
#include "features.h"
#include "layout.h"

// Of the size that keeps a root and its inverse finite; nothing of a scene is as small.
#define SMALL_REAL REAL(1e-30)

DEVICE_FUNCTION real3 quotient_of_vector(real3 v, real divisor) {
  return make_real3(quotient(v.x, divisor), quotient(v.y, divisor), quotient(v.z, divisor));
}

// By its bits: options of the math axis let a compiler take isfinite() for granted.
DEVICE_FUNCTION bool is_finite(real x) {
#if REAL_BITS == 64
  return (bits_of(x) & 0x7FF0000000000000ul) != 0x7FF0000000000000ul;
#else
  return (bits_of(x) & 0x7F800000u) != 0x7F800000u;
#endif
}

DEVICE_FUNCTION real3 vector_of(const Triple t) { return make_real3(t.x, t.y, t.z); }

#endif
