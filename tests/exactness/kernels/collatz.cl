kernel void collatz(global uint* steps) {
  uint n = (uint)get_global_id(0) + 1, count = 0;
  while (n != 1) {
    if (n % 2 == 0)
      n /= 2;
    else
      n = 3 * n + 1;
    ++count;
  }
  steps[get_global_id(0)] = count;
}
