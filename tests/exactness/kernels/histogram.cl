// Of each work-group in local memory by atomics, then added to the one of all.
kernel void histogram(global const uint* values, global uint* bins, uint per_item) {
  local uint own[64];
  const uint local_id = get_local_id(0);
  if (local_id < 64) own[local_id] = 0;
  barrier(CLK_LOCAL_MEM_FENCE);
  for (uint k = 0; k < per_item; ++k) {
    const uint value = values[k * get_global_size(0) + get_global_id(0)] * 2654435761u;
    atomic_inc(&own[value >> 26]);
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  if (local_id < 64) atomic_add(&bins[local_id], own[local_id]);
}
