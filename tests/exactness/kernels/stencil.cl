// Seven points in three dimensions, walls left as they are.
kernel void stencil(global const float* in, global float* out, uint nx, uint ny, uint nz) {
  const uint x = get_global_id(0), y = get_global_id(1), z = get_global_id(2);
  const uint at = (z * ny + y) * nx + x;
  if (x == 0 || y == 0 || z == 0 || x + 1 >= nx || y + 1 >= ny || z + 1 >= nz) {
    if (x < nx && y < ny && z < nz) out[at] = in[at];
    return;
  }
  out[at] = 0.4f * in[at] + 0.1f * (in[at - 1] + in[at + 1] + in[at - nx] + in[at + nx] + in[at - nx * ny] +
                                    in[at + nx * ny]);
}
