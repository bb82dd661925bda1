// Asynchronous copies that libclc leaves out: 3-vectors and halfs. A work-item copies every so many elements;
// that all have arrived is wait_group_events' barrier.

#include "profiler/builtins/vectors.h"

#pragma OPENCL EXTENSION cl_khr_fp16 : enable

WARPGRAIN_INLINE size_t warpgrain_place_in_group(void) {
  return (get_local_id(2) * get_local_size(1) + get_local_id(1)) * get_local_size(0) + get_local_id(0);
}
WARPGRAIN_INLINE size_t warpgrain_size_of_group(void) {
  return get_local_size(0) * get_local_size(1) * get_local_size(2);
}

#define WARPGRAIN_COPY(T, to, from, name, at_target, at_source, ...)                       \
  WARPGRAIN_BUILTIN event_t name(to T* target, const from T* source, size_t count,         \
                                 __VA_ARGS__ event_t event) {                              \
    for (size_t i = warpgrain_place_in_group(); i < count; i += warpgrain_size_of_group()) \
      target[at_target] = source[at_source];                                               \
    return event;                                                                          \
  }
#define WARPGRAIN_COPIES(T)                                                                      \
  WARPGRAIN_COPY(T, local, global, async_work_group_copy, i, i)                                  \
  WARPGRAIN_COPY(T, global, local, async_work_group_copy, i, i)                                  \
  WARPGRAIN_COPY(T, local, global, async_work_group_strided_copy, i, i* stride, size_t stride, ) \
  WARPGRAIN_COPY(T, global, local, async_work_group_strided_copy, i* stride, i, size_t stride, ) \
  WARPGRAIN_BUILTIN void prefetch(const global T* source, size_t count) { (void)source, (void)count; }

WARPGRAIN_COPIES(char3)
WARPGRAIN_COPIES(uchar3)
WARPGRAIN_COPIES(short3)
WARPGRAIN_COPIES(ushort3)
WARPGRAIN_COPIES(int3)
WARPGRAIN_COPIES(uint3)
WARPGRAIN_COPIES(long3)
WARPGRAIN_COPIES(ulong3)
WARPGRAIN_COPIES(float3)
WARPGRAIN_COPIES(double3)
WARPGRAIN_COPIES(half)
WARPGRAIN_COPIES(half2)
WARPGRAIN_COPIES(half3)
WARPGRAIN_COPIES(half4)
WARPGRAIN_COPIES(half8)
WARPGRAIN_COPIES(half16)
