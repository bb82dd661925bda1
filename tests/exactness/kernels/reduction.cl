// Sum of a work-group in local memory, a tree whose active lanes halve.
kernel void reduction(global const float* in, global float* sums, local float* partial) {
  const uint local_id = get_local_id(0);
  partial[local_id] = in[get_global_id(0)];
  barrier(CLK_LOCAL_MEM_FENCE);
  for (uint stride = get_local_size(0) / 2; stride > 0; stride /= 2) {
    if (local_id < stride) partial[local_id] += partial[local_id + stride];
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  if (local_id == 0) sums[get_group_id(0)] = partial[0];
}
