// Lanes end their work-item from within two loops; not all of a work-group's warps are whole.
kernel void loop_return(global const uint* in, global uint* out, uint n) {
  const uint id = get_global_id(0);
  for (uint i = 0; i < n; ++i) {
    uint x = in[(id + i * 64) & 4095];
    for (uint j = 0; j < x % 7; ++j) {
      x = x * 75 + 74;
      if (x % 65 == 3) {
        out[id] = i * 100 + j;
        return;
      }
    }
    out[id] += x & 15;
  }
}
