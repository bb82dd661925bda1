// Each lane makes one round more than the lane before it.
kernel void trip_count(global int* visits, int stride) {
  const int lane = get_local_id(0) % 32;
  int k = 0;
  do {
    visits[k % 4 * stride + get_global_id(0)] += k;
    ++k;
  } while (k <= lane);  // branch: rounds
}
