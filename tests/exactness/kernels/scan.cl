// Inclusive prefix sum of each work-group (Hillis and Steele), in two halves of local memory in turn.
kernel void scan(global const uint* in, global uint* out, local uint* buffer) {
  const uint local_id = get_local_id(0), size = get_local_size(0);
  uint from = 0;
  buffer[local_id] = in[get_global_id(0)];
  barrier(CLK_LOCAL_MEM_FENCE);
  for (uint offset = 1; offset < size; offset *= 2) {
    const uint to = size - from;
    if (local_id >= offset)
      buffer[to + local_id] = buffer[from + local_id] + buffer[from + local_id - offset];
    else
      buffer[to + local_id] = buffer[from + local_id];
    from = to;
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  out[get_global_id(0)] = buffer[from + local_id];
}
