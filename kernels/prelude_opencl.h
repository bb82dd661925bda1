// The words of the kernels in OpenCL C 1.2. Another platform gets a file like this one with the same words;
// the kernels themselves name nothing of a dialect.
#ifndef WARPGRAIN_PRELUDE_OPENCL_H
#define WARPGRAIN_PRELUDE_OPENCL_H

// The precision axis: -D REAL_BITS=64 computes in double.
#ifndef REAL_BITS
#define REAL_BITS 32
#endif
#if REAL_BITS == 64
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
typedef double real;
typedef double3 real3;
typedef double4 real4;
#define REAL(literal) literal
#else
typedef float real;
typedef float3 real3;
typedef float4 real4;
#define REAL(literal) literal##f
#endif

// Its other half: -D FIXED_POINT keeps places as integers (place.h).
#ifdef FIXED_POINT
typedef long coordinate;
typedef long4 Place;
#define make_place(x, y, z, radius) ((long4)(x, y, z, radius))
#define high_product(a, b) mul_hi(a, b)
#else
typedef real coordinate;
typedef real4 Place;
#endif

#define KERNEL __kernel
#define GLOBAL __global
#define CONSTANT __constant
#define LOCAL __local
#define LOCAL_POINTER __local  // to such memory, as a function's parameter
// Always inlined: a law is called from two kernels, and neither may pay for a call.
#define DEVICE_FUNCTION static inline __attribute__((always_inline))
// First in a body: products and sums round one by one.
#define FP_CONTRACT_OFF _Pragma("OPENCL FP_CONTRACT OFF")
#define WORK_GROUP_OF(n) __attribute__((reqd_work_group_size(n, 1, 1)))

#define work_item() ((uint)get_global_id(0))
#define work_item_in_group() ((uint)get_local_id(0))
#define work_group() ((uint)get_group_id(0))
#define work_group_barrier_local() barrier(CLK_LOCAL_MEM_FENCE)
#define work_group_barrier_all() barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE)

#define make_real3(x, y, z) ((real3)(x, y, z))
#define make_real4(v, w) ((real4)(v, w))
#define make_uint2(x, y) ((uint2)(x, y))
#define xyz(v) ((v).xyz)

#define rounded_to_long(x) convert_long_rte(x)
#define rounded_product(a, b) ((a) * (b))  // never part of a multiply-add: in functions with FP_CONTRACT_OFF
// Atomics on integers of 64 bits, for searches that need them: Search::needs_long_atomics.
#ifdef EACH_PAIR_ONCE
#pragma OPENCL EXTENSION cl_khr_int64_base_atomics : enable
#define atomic_add_long(sum, value) atom_add(sum, value)
#endif

// The number of the lowest bit that is set; there is one.
#define lowest_bit(bits) (31 - clz((bits) & (0 - (bits))))

#if REAL_BITS == 64
#define bits_of(x) as_ulong(x)
#define real_of_bits(bits) as_double(bits)
#else
#define bits_of(x) as_uint(x)
#define real_of_bits(bits) as_float(bits)
#endif

// The math axis: -D NATIVE_MATH takes the device's own approximations, whatever their accuracy.
#ifdef NATIVE_MATH
#define square_root(x) native_sqrt(x)
#define reciprocal_square_root(x) native_rsqrt(x)
#define quotient(a, b) native_divide(a, b)
#else
#define square_root(x) sqrt(x)
#define reciprocal_square_root(x) rsqrt(x)
#define quotient(a, b) ((a) / (b))
#endif

#endif
