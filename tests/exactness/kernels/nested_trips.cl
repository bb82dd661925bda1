// Three nested loops, each with a trip count of the lane's own.
kernel void nested_trips(global const uint* trips, global uint* out) {
  const uint id = get_global_id(0);
  uint sum = id;
  for (uint i = 0; i < trips[id] % 5; ++i)
    for (uint j = 0; j < (trips[id] >> 3) % 4 + i; ++j) {
      sum = sum * 5 + j;
      for (uint k = 0; k < sum % 6; ++k) sum ^= trips[(id + k) & 1023] << k;
    }
  out[id] = sum;
}
