// switch, goto, do, nested calls, early return, ternaries; select, shuffle, as_type, conversions.
int collatz(uint n) {
  int steps = 0;
  do {
    n = n & 1 ? 3 * n + 1 : n / 2;
    ++steps;
  } while (n > 1);
  return steps;
}
int classify(int i) {
  switch (i % 6) {
    case 0: return collatz(i + 7);
    case 1:
    case 2: i += 3;
    case 3: i *= 2; break;
    case 4: goto far;
    default: i = -i;
  }
  return i;
far:
  return i > 9 ? 1000 : collatz(i);
}
kernel void flow(global int* a, global uint4* b, global char4* c) {
  const int i = get_global_id(0);
  a[i] = classify(i);
  if (i == 11) return;
  const uint4 v = (uint4)(i, i * i, 3, ~0u);
  b[i] = shuffle(v, (uint4)(3, i, 1, 0)) ^ shuffle2(v, v + 1u, (uint4)(7, 4, i, 2)) ^
         select(v, v.wzyx, (uint4)(0, 1u << 31, 5, i << 31)) ^ as_uint4((float4)(i, 0.5f, -1.0f, 1e10f));
  c[i] = convert_char4_sat((int4)(i * 40, -i * 50, 300, -1)) + convert_char4_rtp((float4)(i * 0.3f, -1.0f, 0.5f, 1.5f)) +
         (char4)(any((int2)(i - 3, 0)), all((int2)(-1, i - 5)), isless(1.0f, (float)i), bitselect((char)i, (char)85, (char)15));
}
