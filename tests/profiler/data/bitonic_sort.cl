// Sorts each work-group's numbers in local memory, with a barrier before every compare-and-exchange.
kernel void bitonic_sort(global int* data, local int* keys) {
  const uint i = get_local_id(0), n = get_local_size(0);
  keys[i] = data[get_global_id(0)];
  for (uint size = 2; size <= n; size *= 2) {
    for (uint distance = size / 2; distance > 0; distance /= 2) {
      barrier(CLK_LOCAL_MEM_FENCE);
      const uint other = i ^ distance;
      if (other > i) {  // branch: lower of the pair
        const int mine = keys[i];
        const int theirs = keys[other];
        if ((mine > theirs) == ((i & size) == 0)) {  // branch: exchange
          keys[i] = theirs;
          keys[other] = mine;
        }
      }
    }
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  data[get_global_id(0)] = keys[i];
}
