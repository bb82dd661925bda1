// Scalars of every type as arguments, and how each is printed.
kernel void arguments(global char* a, global uchar* b, global short* c, global ushort* d, global int* e, global uint* f,
                      global long* g, global ulong* h, global float* p, global double* q, char sa, uchar sb, short sc,
                      ushort sd, int se, uint sf, long sg, ulong sh, float sp, double sq, constant int* k, global int* none) {
  const int i = get_global_id(0);
  a[i] += sa, b[i] += sb, c[i] += sc, d[i] += sd, e[i] += se, f[i] += sf, g[i] += sg, h[i] += sh, p[i] += sp, q[i] += sq;
  e[0] += k[2] + (none == 0);
}
