// Doubles: division and root branch off to code for what is rare.
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
kernel void double_precision(global const double* in, global double* out) {
  const uint id = get_global_id(0);
  double x = in[id];
  for (uint k = 0; k < (id & 7); ++k) {
    x = x / (1 + k * 0.5) + sqrt(x + k);
    if (x > 1000) x *= 1e-310;
  }
  out[id] = x;
}
