// The words of the kernels in CUDA C++, as nvcc and NVRTC take it. It includes nothing, since NVRTC has no headers
// of its own. Lengths and alignments are those of OpenCL C: `long` is 64 bits, real4 aligned to its size.
#ifndef WARPGRAIN_PRELUDE_CUDA_H
#define WARPGRAIN_PRELUDE_CUDA_H

typedef unsigned int uint;
typedef unsigned long ulong;
static_assert(sizeof(long) == 8, "a platform whose long has 64 bits");

#ifndef REAL_BITS
#define REAL_BITS 32
#endif
#if REAL_BITS == 64
typedef double real;
#define REAL(literal) literal
#else
typedef float real;
#define REAL(literal) literal##f
#endif

#define KERNEL extern "C" __global__
#define GLOBAL
#define CONSTANT
#define LOCAL __shared__
#define LOCAL_POINTER
#define DEVICE_FUNCTION static __device__ __forceinline__
#define FP_CONTRACT_OFF
#define WORK_GROUP_OF(n) __launch_bounds__(n)

// CUDA has float3 and double4, but no arithmetic on them.
struct real3 {
  real x, y, z;
};
struct alignas(4 * sizeof(real)) real4 {
  real x, y, z, w;
};
DEVICE_FUNCTION real3 make_real3(real x, real y, real z) { return {x, y, z}; }
DEVICE_FUNCTION real4 make_real4(real3 v, real w) { return {v.x, v.y, v.z, w}; }
DEVICE_FUNCTION real3 xyz(real4 v) { return {v.x, v.y, v.z}; }
DEVICE_FUNCTION real3 operator+(real3 a, real3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
DEVICE_FUNCTION real3 operator-(real3 a, real3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
DEVICE_FUNCTION real3 operator-(real3 a) { return {-a.x, -a.y, -a.z}; }
DEVICE_FUNCTION real3 operator*(real3 a, real s) { return {a.x * s, a.y * s, a.z * s}; }
DEVICE_FUNCTION real3 operator*(real s, real3 a) { return a * s; }
DEVICE_FUNCTION void operator+=(real3& a, real3 b) { a = a + b; }
DEVICE_FUNCTION void operator-=(real3& a, real3 b) { a = a - b; }
DEVICE_FUNCTION void operator*=(real3& a, real s) { a = a * s; }
DEVICE_FUNCTION real dot(real3 a, real3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
DEVICE_FUNCTION real3 cross(real3 a, real3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

#ifdef FIXED_POINT
typedef long coordinate;
struct alignas(32) Place {
  long x, y, z, w;
};
DEVICE_FUNCTION Place make_place(long x, long y, long z, long radius) { return {x, y, z, radius}; }
#define high_product(a, b) __mul64hi(a, b)
#ifndef LONG_MIN
#define LONG_MIN (-0x7FFFFFFFFFFFFFFFl - 1)
#endif
#else
typedef real coordinate;
typedef real4 Place;
#endif

#define work_item() (blockIdx.x * blockDim.x + threadIdx.x)
#define work_item_in_group() (threadIdx.x)
#define work_group() (blockIdx.x)
#define work_group_barrier_local() __syncthreads()
#define work_group_barrier_all() __syncthreads()

template <class T>
DEVICE_FUNCTION T clamp(T x, T low, T high) {
  return x < low ? low : x > high ? high : x;
}

DEVICE_FUNCTION real3 vload3(uint place, const real* values) {
  return {values[3 * place], values[3 * place + 1], values[3 * place + 2]};
}
DEVICE_FUNCTION void vstore3(real3 v, uint place, real* values) {
  values[3 * place] = v.x;
  values[3 * place + 1] = v.y;
  values[3 * place + 2] = v.z;
}

// Numbers of 16 bits by their bits: cuda_fp16.h is none of NVRTC's own headers.
typedef unsigned short half;
DEVICE_FUNCTION float vload_half(uint place, const half* values) {
  float value;
  asm("cvt.f32.f16 %0, %1;" : "=f"(value) : "h"(values[place]));
  return value;
}
DEVICE_FUNCTION void vstore_half(float value, uint place, half* values) {
  asm("cvt.rn.f16.f32 %0, %1;" : "=h"(values[place]) : "f"(value));
}

DEVICE_FUNCTION uint atomic_inc(uint* value) { return atomicAdd(value, 1u); }
DEVICE_FUNCTION uint atomic_min(uint* value, uint other) { return atomicMin(value, other); }
DEVICE_FUNCTION uint atomic_max(uint* value, uint other) { return atomicMax(value, other); }
#define atomic_add_long(sum, value) \
  atomicAdd(reinterpret_cast<unsigned long long*>(sum), static_cast<unsigned long long>(value))

#define lowest_bit(bits) (31 - __clz((bits) & (0 - (bits))))

#if REAL_BITS == 64
#define rounded_to_long(x) ((long)__double2ll_rn(x))
#define rounded_product(a, b) __dmul_rn(a, b)
#define bits_of(x) ((ulong)__double_as_longlong(x))
#define real_of_bits(bits) __longlong_as_double((long long)(bits))
#else
#define rounded_to_long(x) ((long)__float2ll_rn(x))
#define rounded_product(a, b) __fmul_rn(a, b)
#define bits_of(x) __float_as_uint(x)
#define real_of_bits(bits) __uint_as_float(bits)
#endif

#ifdef NATIVE_MATH
DEVICE_FUNCTION float square_root(float x) {
  float root;
  asm("sqrt.approx.f32 %0, %1;" : "=f"(root) : "f"(x));
  return root;
}
DEVICE_FUNCTION float reciprocal_square_root(float x) {
  float root;
  asm("rsqrt.approx.f32 %0, %1;" : "=f"(root) : "f"(x));
  return root;
}
#define quotient(a, b) __fdividef(a, b)
#else
#define square_root(x) sqrt(x)
#define reciprocal_square_root(x) rsqrt(x)
#define quotient(a, b) ((a) / (b))
#endif

#endif
