// The same with a trip count of each lane's own.
kernel void unroll_varying(global const float* in, global const uint* trips, global float* out) {
  const uint id = get_global_id(0);
  float sum = 0;
  const uint n = trips[id] % 23;
  for (uint k = 0; k < n; ++k) sum += in[(id + k) & 4095];
  out[id] = sum;
}
