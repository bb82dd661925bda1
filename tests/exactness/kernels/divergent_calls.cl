// The same function called on both sides of a branch, and in a loop that lanes leave one by one.
__attribute__((noinline)) float series(float x, uint n) {
  float sum = 0, term = x;
  for (uint k = 1; k <= n; ++k) {
    sum += term;
    term *= x / (float)k;
    if (term < 1e-6f) return sum;
  }
  return sum + term;
}

kernel void divergent_calls(global const float* in, global float* out) {
  const uint id = get_global_id(0);
  float x = in[id] * 0.0009f;
  if (id % 3 == 1)
    x = series(x, id & 7) * 2;
  else if (id % 5 != 0)
    x = series(1 - x, 12);
  for (uint k = 0; k < id % 6; ++k) x += series(x * 0.01f, k);
  out[id] = x;
}
