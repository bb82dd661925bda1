// The same, rows of like length beside each other: order[i] is the row of work-item i.
kernel void product(global float* result, global const uint* starts, global const uint* columns,
                    global const float* values, global const float* x, global const uint* order) {
  const uint row = order[get_global_id(0)];
  float sum = 0;
  for (uint k = starts[row]; k < starts[row + 1]; ++k)  // branch: next entry
    sum += values[k] * x[columns[k]];
  result[row] = sum;
}
