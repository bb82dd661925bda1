// What the special-function unit does: approximate functions, divisions, roots and conversions.
kernel void special_functions(global const float* in, global float* out, global int* whole) {
  const uint id = get_global_id(0);
  const float x = in[id] * 0.001f + 1;
  float y = native_sin(x) + native_cos(x) + native_exp2(x) + native_log2(x);
  if (id & 1) y += native_rsqrt(x) * native_recip(x + y);
  y += sqrt(x) / (y + 3);
  out[id] = y;
  whole[id] = convert_int_rte(y) + (int)(x * 8) + popcount(id) + (int)clz(id);
}
