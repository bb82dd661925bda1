kernel void mandelbrot(global uint* counts, uint width, uint height, uint limit) {
  const uint x = get_global_id(0), y = get_global_id(1);
  const float re = -2.2f + 3.0f * (float)x / (float)width, im = -1.3f + 2.6f * (float)y / (float)height;
  float a = 0, b = 0;
  uint n = 0;
  while (n < limit && a * a + b * b < 4) {
    const float next = a * a - b * b + re;
    b = 2 * a * b + im;
    a = next;
    ++n;
  }
  counts[y * width + x] = n;
}
