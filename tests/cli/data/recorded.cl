// Kernels of the program that tests record.

kernel void scale(global float* x, float factor, uint n) {
  const uint i = get_global_id(0);
  if (i < n) x[i] *= factor;
}

// Work that depends on what an earlier launch has left.
kernel void sum_groups(global const float* x, global float* sums, local float* part) {
  const uint lane = get_local_id(0);
  float sum = 0;
  for (int k = 0; k < (int)x[get_global_id(0)] % STRIDE; ++k) sum += x[get_global_id(0)];
  part[lane] = sum;
  barrier(CLK_LOCAL_MEM_FENCE);
  for (uint n = get_local_size(0) / 2; n > 0; n /= 2) {
    if (lane < n) part[lane] += part[lane + n];
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  if (lane == 0) sums[get_group_id(0)] = part[0];
}

kernel void count_bits(global int* part, global int* optional) {
  const size_t i = get_global_id(1) * get_global_size(0) + get_global_id(0);
  int bits = 0;
  for (int rest = part[i]; rest != 0; rest &= rest - 1) ++bits;
  part[i] = bits;
  if (optional) optional[i] = bits;
}

// As often as its buffer says.
kernel void repeat(global int* numbers) {
  const size_t i = get_global_id(0);
  for (int k = numbers[i]; k > 0; --k) numbers[i] ^= k;
}

kernel void paint(write_only image2d_t image) {
  write_imagef(image, (int2)(get_global_id(0), get_global_id(1)), (float4)(1));
}
