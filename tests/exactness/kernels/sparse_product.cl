// Sparse matrix times vector, a row a work-item; row r of the matrix has (r * 7) % 29 entries.
kernel void sparse_product(global const uint* row_begin, global const float* values, global const float* x,
                           global float* y, uint n_rows, uint n_columns) {
  const uint row = get_global_id(0);
  if (row >= n_rows) return;
  float sum = 0;
  const uint begin = row_begin[row], end = begin + (row * 7) % 29;
  for (uint k = begin; k < end; ++k) {
    const uint column = (k * 2654435761u >> 8) % n_columns;
    sum += values[k] * x[column];
  }
  y[row] = sum;
}
