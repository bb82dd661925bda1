// Conditions whose right sides load: they cannot be computed ahead.
kernel void short_circuit(global const uint* a, global const uint* b, global uint* out, uint n) {
  const uint id = get_global_id(0);
  uint found = 0;
  for (uint k = 0; k < 8; ++k) {
    const uint at = (id * 3 + k * 17) % n;
    if (a[at] % 3 == 0 && (b[a[at] % n] % 5 == 1 || a[(at + 1) % n] % 7 == 2) && b[at] != id) found += k;
    if (a[at] % 4 == 1 || (b[at] % 6 == 3 && a[b[at] % n] % 2 == 0)) found ^= 1u << k;
  }
  out[id] = found;
}
