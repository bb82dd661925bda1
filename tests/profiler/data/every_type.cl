// Every type of argument that a launch file can give.
typedef struct {
  int factor;
  float offset;
} Line;
typedef uint4 Quad;

kernel void every_type(global const float* a, global const Quad* b, global int* c, global char* d, float s, int2 t,
                       local float* scratch, global double* e, global ulong* g, constant ushort* h, Line line,
                       global float* nothing) {
  const int i = get_global_id(0);
  scratch[get_local_id(0)] = a[i];
  barrier(CLK_LOCAL_MEM_FENCE);
  c[i] = (int)(b[i].x + b[i].w) + t.x * t.y + (int)s + h[i] + line.factor;
  d[i] = (char)(-i);
  e[i] = scratch[get_local_id(0) ^ 1] / 3.0 + line.offset;
  g[i] += i;
  if (nothing) nothing[i] = 1;
}
