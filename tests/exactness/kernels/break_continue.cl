// Two nested loops that lanes leave and shorten at places of their own.
kernel void break_continue(global const uint* in, global uint* out) {
  const uint id = get_global_id(0);
  uint sum = in[id];
  for (uint i = 0; i < 20; ++i) {
    if ((sum + i) % 7 == 3) continue;
    for (uint j = i; j < 16; ++j) {
      if ((sum ^ j) % 11 == 5) break;
      if ((sum & j) == 1) continue;
      sum += j * i + 1;
    }
    if (sum % 31 == 17) break;
    sum ^= i << 3;
  }
  out[id] = sum;
}
