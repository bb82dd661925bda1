// Functions and divisions of full accuracy: long code, with paths for what is rare.
kernel void exact_functions(global const float* in, global float* out) {
  const uint id = get_global_id(0);
  const float x = in[id] * 0.37f - 900;
  float y = sin(x) + exp(x * 0.01f);
  if (id % 3 != 0) y *= log(fabs(x) + 1) / (cos(x) + 2);
  out[id] = y + pow(fabs(x), 0.3f);
}
