// A trip count that is known, and too large to be unrolled whole.
kernel void unroll_constant(global const float* in, global float* out) {
  const uint id = get_global_id(0);
  float sum = 0;
  for (uint k = 0; k < 200; ++k) sum = sum * 0.99f + in[(id + k * 3) & 4095];
  out[id] = sum;
}
