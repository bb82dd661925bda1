// One pass of a least-significant-digit radix sort of each work-group's keys, two bits: ranks by counting.
kernel void radix_sort_pass(global const uint* keys, global uint* out, uint shift) {
  local uint counts[4 * 128];
  local uint starts[4];
  const uint local_id = get_local_id(0), size = get_local_size(0);
  const uint key = keys[get_global_id(0)] * 2654435761u;
  const uint digit = (key >> shift) & 3;
  for (uint d = 0; d < 4; ++d) counts[d * size + local_id] = d == digit;
  barrier(CLK_LOCAL_MEM_FENCE);
  for (uint offset = 1; offset < size; offset *= 2) {
    uint sum[4];
    for (uint d = 0; d < 4; ++d) sum[d] = local_id >= offset ? counts[d * size + local_id - offset] : 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    for (uint d = 0; d < 4; ++d) counts[d * size + local_id] += sum[d];
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  if (local_id == 0) {
    uint start = 0;
    for (uint d = 0; d < 4; ++d) {
      starts[d] = start;
      start += counts[d * size + size - 1];
    }
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  const uint place = starts[digit] + counts[digit * size + local_id] - 1;
  out[get_group_id(0) * size + place] = key;
}
