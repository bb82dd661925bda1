// Half of each warp goes one way.
kernel void half_and_half(global int* a, global double* b) {
  const int i = get_global_id(0);
  if (get_local_id(0) % 32 < 16) {  // branch: half
    a[i] = 3 * i;
  } else {
    b[i] = 0.5 * i;
  }
}
