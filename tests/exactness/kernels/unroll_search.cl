// Unrollable, with a second way out.
kernel void unroll_search(global const uint* in, global uint* out, uint n) {
  const uint id = get_global_id(0);
  const uint wanted = in[(id * 37) & 2047] & 63;
  uint at = n;
  for (uint k = 0; k < n; ++k)
    if ((in[(id + k * 5) & 2047] & 63) == wanted) {
      at = k;
      break;
    }
  out[id] = at;
}
