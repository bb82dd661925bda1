// Every fourth lane leaves at once; the last 24 of 64 items have a warp that is not full.
kernel void early_return(global uint* out, uint n) {
  const uint i = get_global_id(0);
  if (i % 4 == 0) return;  // branch: leave
  for (uint k = 0; k < n; ++k) {
    out[i] += i ^ k;
  }
}
