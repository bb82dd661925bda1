// Four ways out of one branch.
kernel void four_ways(global int* a, global double* b, global short* c, global int* sum) {
  const int i = get_global_id(0);
  switch (i % 8) {
    case 0:
      a[i] = i;
      break;
    case 1:
      b[i] = i / 3.0;
      break;
    case 2:
      c[i] = (short)(-i);
      break;
    case 5:
      atomic_add(sum, i);
      break;
  }
}
