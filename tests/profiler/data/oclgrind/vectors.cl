// Vectors of every width as arguments, in buffers and in local memory.
kernel void vectors(global char2* a, global uchar3* b, global short4* c, global ushort8* d, global int16* e, global uint2* f,
                    global long3* g, global ulong4* h, global float8* p, global double2* q, char16 s, short2 t, int3 u,
                    ulong4 v, float8 w, double3 x, local int3* scratch) {
  const int i = get_global_id(0), l = get_local_id(0);
  scratch[l] = u + i;
  local float4 shared[2];
  shared[l] = w.even * i;
  barrier(CLK_LOCAL_MEM_FENCE);
  a[i] += s.s3f;
  b[i] = (uchar3)(1, 2, i) + convert_uchar3(scratch[l ^ 1]);
  c[i] = c[i].wzyx * t.xyxy;
  d[i].odd = (ushort4)(i);
  e[i] = e[i].sfedcba9876543210 + scratch[l].xyzzxyzzxyzzxyzz;
  f[i] = f[i] << (uint2)(1, i);
  vstore3((long3)(g[i].x, -g[i].yz) * i, i * 4 / 3, (global long*)g + i * 4 % 3);
  h[i] = h[i] | v.s3210;
  p[i].lo = p[i].hi + shared[l ^ 1];
  q[i] = x.zy / (double2)(3, i + 1);
}
