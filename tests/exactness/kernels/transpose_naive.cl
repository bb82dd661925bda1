// Columns read, rows written: 32 sectors a load.
kernel void transpose_naive(global const float* in, global float* out, uint width, uint height) {
  const uint x = get_global_id(0), y = get_global_id(1);
  out[y * width + x] = in[x * height + y];
}
