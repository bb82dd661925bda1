// A sparse matrix times a vector: a work-item a row.
kernel void product(global float* result, global const uint* starts, global const uint* columns,
                    global const float* values, global const float* x) {
  const uint row = get_global_id(0);
  float sum = 0;
  for (uint k = starts[row]; k < starts[row + 1]; ++k)  // branch: next entry
    sum += values[k] * x[columns[k]];
  result[row] = sum;
}
