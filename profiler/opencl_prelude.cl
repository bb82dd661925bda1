// Comes before every kernel. libclc's native functions and its square roots compile to what NVPTX cannot
// select, or to long exact code; on the devices that OpenCL's accuracy rules are written for they are one or
// two approximate instructions. `nodebug` gives those the line of the call.
#if __OPENCL_C_VERSION__ < 120  // which has no static functions
#define WARPGRAIN_INLINE inline __attribute__((overloadable, always_inline, nodebug))
#else
#define WARPGRAIN_INLINE static inline __attribute__((overloadable, always_inline, nodebug))
#endif

#define WARPGRAIN_VECTORS_OF_1(f, T)                                         \
  WARPGRAIN_INLINE T##2 f(T##2 x) { return (T##2)(f(x.x), f(x.y)); }         \
  WARPGRAIN_INLINE T##3 f(T##3 x) { return (T##3)(f(x.x), f(x.y), f(x.z)); } \
  WARPGRAIN_INLINE T##4 f(T##4 x) { return (T##4)(f(x.lo), f(x.hi)); }       \
  WARPGRAIN_INLINE T##8 f(T##8 x) { return (T##8)(f(x.lo), f(x.hi)); }       \
  WARPGRAIN_INLINE T##16 f(T##16 x) { return (T##16)(f(x.lo), f(x.hi)); }

#define WARPGRAIN_VECTORS_OF_2(f)                                                                  \
  WARPGRAIN_INLINE float2 f(float2 x, float2 y) { return (float2)(f(x.x, y.x), f(x.y, y.y)); }     \
  WARPGRAIN_INLINE float3 f(float3 x, float3 y) { return (float3)(f(x.xy, y.xy), f(x.z, y.z)); }   \
  WARPGRAIN_INLINE float4 f(float4 x, float4 y) { return (float4)(f(x.lo, y.lo), f(x.hi, y.hi)); } \
  WARPGRAIN_INLINE float8 f(float8 x, float8 y) { return (float8)(f(x.lo, y.lo), f(x.hi, y.hi)); } \
  WARPGRAIN_INLINE float16 f(float16 x, float16 y) { return (float16)(f(x.lo, y.lo), f(x.hi, y.hi)); }

#define WARPGRAIN_FUNCTION_1(f, expression)                            \
  WARPGRAIN_INLINE float warpgrain_##f(float x) { return expression; } \
  WARPGRAIN_VECTORS_OF_1(warpgrain_##f, float)

#define WARPGRAIN_FUNCTION_2(f, expression)                                     \
  WARPGRAIN_INLINE float warpgrain_##f(float x, float y) { return expression; } \
  WARPGRAIN_VECTORS_OF_2(warpgrain_##f)

WARPGRAIN_INLINE float warpgrain_rcp(float x) {
  float y;
  __asm__("rcp.approx.f32 %0, %1;" : "=f"(y) : "f"(x));
  return y;
}

WARPGRAIN_FUNCTION_1(native_sin, __nvvm_sin_approx_f(x))
WARPGRAIN_FUNCTION_1(native_cos, __nvvm_cos_approx_f(x))
WARPGRAIN_FUNCTION_1(native_tan, __nvvm_div_approx_f(__nvvm_sin_approx_f(x), __nvvm_cos_approx_f(x)))
WARPGRAIN_FUNCTION_1(native_exp2, __nvvm_ex2_approx_f(x))
WARPGRAIN_FUNCTION_1(native_exp, __nvvm_ex2_approx_f(x* M_LOG2E_F))
WARPGRAIN_FUNCTION_1(native_exp10, __nvvm_ex2_approx_f(x*(M_LN10_F* M_LOG2E_F)))
WARPGRAIN_FUNCTION_1(native_log2, __nvvm_lg2_approx_f(x))
WARPGRAIN_FUNCTION_1(native_log, __nvvm_lg2_approx_f(x) * M_LN2_F)
WARPGRAIN_FUNCTION_1(native_log10, __nvvm_lg2_approx_f(x) * (M_LN2_F * M_LOG10E_F))
WARPGRAIN_FUNCTION_1(native_recip, warpgrain_rcp(x))
WARPGRAIN_FUNCTION_1(native_sqrt, __nvvm_sqrt_approx_f(x))
WARPGRAIN_FUNCTION_1(native_rsqrt, __nvvm_rsqrt_approx_f(x))
WARPGRAIN_FUNCTION_2(native_divide, __nvvm_div_approx_f(x, y))
WARPGRAIN_FUNCTION_2(native_powr, __nvvm_ex2_approx_f(y* __nvvm_lg2_approx_f(x)))

#define native_sin(...) warpgrain_native_sin(__VA_ARGS__)
#define native_cos(...) warpgrain_native_cos(__VA_ARGS__)
#define native_tan(...) warpgrain_native_tan(__VA_ARGS__)
#define native_exp2(...) warpgrain_native_exp2(__VA_ARGS__)
#define native_exp(...) warpgrain_native_exp(__VA_ARGS__)
#define native_exp10(...) warpgrain_native_exp10(__VA_ARGS__)
#define native_log2(...) warpgrain_native_log2(__VA_ARGS__)
#define native_log(...) warpgrain_native_log(__VA_ARGS__)
#define native_log10(...) warpgrain_native_log10(__VA_ARGS__)
#define native_recip(...) warpgrain_native_recip(__VA_ARGS__)
#define native_sqrt(...) warpgrain_native_sqrt(__VA_ARGS__)
#define native_rsqrt(...) warpgrain_native_rsqrt(__VA_ARGS__)
#define native_divide(...) warpgrain_native_divide(__VA_ARGS__)
#define native_powr(...) warpgrain_native_powr(__VA_ARGS__)

// Doubles keep their exact forms; so do floats under -cl-fp32-correctly-rounded-divide-sqrt.
#ifdef WARPGRAIN_EXACT_SQUARE_ROOT
WARPGRAIN_FUNCTION_1(sqrt, __nvvm_sqrt_rn_f(x))
#else
WARPGRAIN_FUNCTION_1(sqrt, __nvvm_sqrt_approx_f(x))
#endif
WARPGRAIN_FUNCTION_1(rsqrt, __nvvm_rsqrt_approx_f(x))
WARPGRAIN_INLINE double warpgrain_sqrt(double x) { return __nvvm_sqrt_rn_d(x); }
WARPGRAIN_VECTORS_OF_1(warpgrain_sqrt, double)
WARPGRAIN_INLINE double warpgrain_rsqrt(double x) { return 1.0 / __nvvm_sqrt_rn_d(x); }
WARPGRAIN_VECTORS_OF_1(warpgrain_rsqrt, double)

#pragma OPENCL EXTENSION cl_khr_fp16 : enable
WARPGRAIN_INLINE half warpgrain_sqrt(half x) { return (half)__nvvm_sqrt_rn_f(x); }
WARPGRAIN_VECTORS_OF_1(warpgrain_sqrt, half)
WARPGRAIN_INLINE half warpgrain_rsqrt(half x) { return (half)__nvvm_rsqrt_approx_f(x); }
WARPGRAIN_VECTORS_OF_1(warpgrain_rsqrt, half)
#pragma OPENCL EXTENSION cl_khr_fp16 : disable

#define sqrt(...) warpgrain_sqrt(__VA_ARGS__)
#define rsqrt(...) warpgrain_rsqrt(__VA_ARGS__)

// Declared by OpenCL, missing in libclc for NVPTX. Launches have three dimensions, and no offset.
#define get_work_dim() 3u
#define get_global_offset(dimension) ((size_t)0)
#define mad_hi(a, b, c) ((__typeof__(mul_hi(a, b)))(mul_hi(a, b) + (c)))

// Launches whose last work-groups are smaller: %ntid is the enqueued size, and the simulator gives the global size.
#ifdef WARPGRAIN_SMALLER_GROUPS
WARPGRAIN_INLINE size_t warpgrain_global_size(uint dimension) {
  uint x = 1;
  if (dimension == 0) __asm__("mov.u32 %0, %%envreg29;" : "=r"(x));
  if (dimension == 1) __asm__("mov.u32 %0, %%envreg30;" : "=r"(x));
  if (dimension == 2) __asm__("mov.u32 %0, %%envreg31;" : "=r"(x));
  return x;
}
WARPGRAIN_INLINE size_t warpgrain_enqueued_local_size(uint dimension) { return get_local_size(dimension); }
WARPGRAIN_INLINE size_t warpgrain_local_size(uint dimension) {
  const size_t enqueued = get_local_size(dimension);
  return min(enqueued, warpgrain_global_size(dimension) - get_group_id(dimension) * enqueued);
}
#define get_global_size(dimension) warpgrain_global_size(dimension)
#define get_local_size(dimension) warpgrain_local_size(dimension)
#define get_enqueued_local_size(dimension) warpgrain_enqueued_local_size(dimension)
#endif

// What OpenCL C 2.0 adds of such functions.
#if __OPENCL_C_VERSION__ >= 200
#ifndef WARPGRAIN_SMALLER_GROUPS
#define get_enqueued_local_size(dimension) get_local_size(dimension)
#endif
#define get_local_linear_id() \
  ((get_local_id(2) * get_local_size(1) + get_local_id(1)) * get_local_size(0) + get_local_id(0))
#define get_global_linear_id() \
  ((get_global_id(2) * get_global_size(1) + get_global_id(1)) * get_global_size(0) + get_global_id(0))
#define work_group_barrier(flags, ...) barrier(flags)
#endif
