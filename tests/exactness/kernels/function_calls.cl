// Functions that stay functions.
__attribute__((noinline)) uint mix(uint a, uint b) {
  a ^= b >> 3;
  for (uint k = 0; k < (b & 3); ++k) a = a * 33 + k;
  return a;
}
__attribute__((noinline)) uint choose(uint a, uint b) { return a % 3 == 0 ? mix(a, b) : mix(b, a) + 1; }

kernel void function_calls(global const uint* in, global uint* out) {
  const uint id = get_global_id(0);
  uint x = in[id];
  for (uint k = 0; k < 5; ++k) x += choose(x, k + id);
  out[id] = x;
}
