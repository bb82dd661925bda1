// In round k, lanes with (lane + k) % 4 == 0 skip the rest of the round, and lanes with lane % 8 == k leave.
kernel void break_and_continue(global int* first, global float* second, int rounds) {
  const int i = get_global_id(0);
  const int lane = get_local_id(0) % 32;
  for (int k = 0; k < rounds; ++k) {
    if ((lane + k) % 4 == 0) continue;  // branch: skip
    first[i] += k + 1;
    if (lane % 8 == k) break;  // branch: leave
    second[i] *= 1.5f;
  }
}
