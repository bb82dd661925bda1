// A loop on either side of a branch, and one behind it.
kernel void both_sides_loop(global const uint* in, global uint* out) {
  const uint id = get_global_id(0);
  uint x = in[id];
  if (x % 3 != 1) {
    do {
      x = (x >> 1) + (x & 1) * 77;
    } while (x % 16 > 3);
  } else {
    for (uint k = x % 10; k > 0; --k) x += k * k;
  }
  while (x > 500) x -= x / 5 + 3;
  out[id] = x;
}
