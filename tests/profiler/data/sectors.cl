// The same loads in four orders.
kernel void sectors(global const float* x, global const int* order, global float* out, global float4* wide) {
  const int i = get_global_id(0);
  float sum = x[i];
  sum += x[i + 1];
  sum += x[32 * i];
  sum += x[7];
  sum += x[order[i]];
  out[i] = sum;
  wide[63 - i] = (float4)(sum, i, -sum, 0.5f);
}
