// Returns at several depths, one of them in a loop.
kernel void early_exit(global const uint* in, global uint* out, uint n) {
  const uint id = get_global_id(0);
  if (id >= n) return;
  uint x = in[id];
  if (x % 3 == 0) {
    out[id] = 1;
    return;
  }
  for (uint k = 1; k < 24; ++k) {
    x = x * 1664525u + 1013904223u;
    if (x >> 28 == 7) {
      out[id] = k;
      if (x & 1) return;
      x ^= 0x55555555u;
    }
    if (x >> 27 == 3) return;
  }
  out[id] = x;
}
