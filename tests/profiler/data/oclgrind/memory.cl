// Local memory, barriers, fences, copies with events, half storage, loads and stores of vectors.
kernel void memory(global int* in, global int* out, global ushort* halfs, global uchar* bytes, local int* tile,
                   global const int* missing) {
  local int inner[8];
  local struct {
    int sum;
    float most;
  } shared;
  const int i = get_global_id(0), l = get_local_id(0), n = get_local_size(0), group = get_group_id(0);
  event_t e = async_work_group_copy(tile, in + group * n, n, 0);
  e = async_work_group_strided_copy(inner, in + group * n, n / 2, 2, e);
  if (l == 0) shared.sum = 0;
  prefetch(in, 4);
  wait_group_events(1, &e);
  atomic_add(&shared.sum, tile[l]);
  barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
  out[i] = shared.sum + inner[l / 2] + (missing ? missing[0] : 100);
  mem_fence(CLK_LOCAL_MEM_FENCE);
  vstore_half(0.1f * (i + 1), i, (global half*)halfs);
  vstore_half2_rtz((float2)(1.0f / 3, -2.0f / 3), 2 + i, (global half*)halfs);
  vstore3((uchar3)(i, i + 1, i + 2), i, bytes);
  barrier(CLK_GLOBAL_MEM_FENCE);
  out[i] += (int)(vload_half(i, (global half*)halfs) * 1000) + vload3(i ^ 1, bytes).z;
  e = async_work_group_copy(out + 8 + group * n, tile, n, 0);
  e = async_work_group_strided_copy(out + 16 + group * n, tile, n / 2, 2, e);
  wait_group_events(1, &e);
}
