// A trip count that all lanes share and the compiler does not know: copies of the body, and a remainder.
kernel void unroll_remainder(global const float* in, global float* out, uint n) {
  const uint id = get_global_id(0);
  float sum = 0;
  for (uint k = 0; k < n; ++k) sum += in[id + k];
  out[id] = sum;
}
