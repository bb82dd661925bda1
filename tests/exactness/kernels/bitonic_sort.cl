// Each work-group sorts its own keys in local memory.
kernel void bitonic_sort(global uint* keys, local uint* sorted) {
  const uint local_id = get_local_id(0);
  uint key = keys[get_global_id(0)];
  key = key * 2654435761u ^ (key >> 7);  // the range of the launch file, shuffled
  sorted[local_id] = key;
  barrier(CLK_LOCAL_MEM_FENCE);
  for (uint size = 2; size <= get_local_size(0); size *= 2)
    for (uint stride = size / 2; stride > 0; stride /= 2) {
      const uint other = local_id ^ stride;
      if (other > local_id) {
        const uint a = sorted[local_id], b = sorted[other];
        const bool ascending = (local_id & size) == 0;
        if ((a > b) == ascending) {
          sorted[local_id] = b;
          sorted[other] = a;
        }
      }
      barrier(CLK_LOCAL_MEM_FENCE);
    }
  keys[get_global_id(0)] = sorted[local_id];
}
