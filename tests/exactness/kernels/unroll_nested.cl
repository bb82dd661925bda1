// An inner loop that is unrolled with a remainder in an outer one that is not; a branch in its body.
kernel void unroll_nested(global const uint* in, global uint* out, uint rows) {
  const uint id = get_global_id(0);
  uint sum = 0;
  for (uint row = 0; row < rows; ++row) {
    const uint n = in[(id * 7 + row) & 2047] % 9;
    for (uint k = 0; k < n; ++k) {
      const uint value = in[(row * 64 + k + id) & 2047];
      if (value & 2) sum += value;
    }
    sum ^= row;
  }
  out[id] = sum;
}
