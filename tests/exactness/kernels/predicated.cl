// Branches so short that predicates replace them all.
kernel void predicated(global const int* in, global int* out) {
  const uint id = get_global_id(0);
  int x = in[id];
  if (x > 100) x -= 100;
  if (x & 4) x = -x;
  x = x < 0 ? x + 7 : x;
  if (x > 40 && x < 60) x = 50;
  const int y = x % 2 == 0 ? x / 2 : 3 * x;
  if (id % 5 == 0) out[id] = y;
  out[id + get_global_size(0)] = min(y, x) + (x == y);
}
