// Loads and stores of vectors, and with strides; half of the lanes in one part.
kernel void vector_access(global const float4* a, global const uchar4* b, global const float* c,
                          global float* out, global float2* pairs) {
  const uint id = get_global_id(0);
  const float4 v = a[id ^ 3];
  const uchar4 u = b[id];
  float sum = v.x + v.y * v.z + v.w + u.x + u.z;
  if (id & 16) sum += c[id * 3];
  out[id * 2] = sum;
  pairs[id] = (float2)(sum, c[id * 5 + 1]);
}
