kernel void binary_search(global const uint* sorted, uint n, global uint* places) {
  const uint wanted = (uint)get_global_id(0) * 2654435761u >> 14;
  uint low = 0, high = n;
  while (low < high) {
    const uint middle = (low + high) / 2;
    if (sorted[middle] == wanted) {
      low = middle;
      break;
    }
    if (sorted[middle] < wanted)
      low = middle + 1;
    else
      high = middle;
  }
  places[get_global_id(0)] = low;
}
