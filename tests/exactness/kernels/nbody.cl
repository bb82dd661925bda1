// All pairs, bodies by tiles of local memory.
kernel void nbody(global const float4* bodies, global float4* accelerations, uint n, local float4* tile) {
  const float4 own = bodies[get_global_id(0)];
  float4 acceleration = (float4)(0);
  for (uint first = 0; first < n; first += get_local_size(0)) {
    tile[get_local_id(0)] = bodies[first + get_local_id(0)];
    barrier(CLK_LOCAL_MEM_FENCE);
    for (uint k = 0; k < get_local_size(0); ++k) {
      const float4 to = tile[k] - own;
      const float inverse = native_rsqrt(to.x * to.x + to.y * to.y + to.z * to.z + 1e-3f);
      acceleration += to * (inverse * inverse * inverse);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  accelerations[get_global_id(0)] = acceleration;
}
