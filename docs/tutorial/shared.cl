// The same, eight work-items a row.
kernel void product(global float* result, global const uint* starts, global const uint* columns,
                    global const float* values, global const float* x) {
  local float sums[64];
  const uint item = get_local_id(0), row = get_global_id(0) / 8;
  float sum = 0;
  for (uint k = starts[row] + item % 8; k < starts[row + 1]; k += 8)  // branch: next eight entries
    sum += values[k] * x[columns[k]];
  sums[item] = sum;
  barrier(CLK_LOCAL_MEM_FENCE);
  if (item % 8 == 0) {  // branch: first of its row
    for (uint k = 1; k < 8; ++k) sum += sums[item + k];
    result[row] = sum;
  }
}
