// Three nested branches: eight ways through, each with work that predicates cannot hold.
kernel void branch_tree(global uint* x) {
  const uint id = get_global_id(0);
  uint v = x[id];
#define WORK(n) \
  for (uint k = 0; k < n; ++k) v = v * 29 + x[(v + k) & 255]
#define LEVEL(bit, yes, no) \
  if (id & bit) {           \
    WORK(1 + bit % 3);      \
    yes;                    \
  } else {                  \
    WORK(2);                \
    no;                     \
  }
  LEVEL(1, LEVEL(2, LEVEL(4, v += 1, v ^= 9), LEVEL(8, WORK(3), v -= 3)),
        LEVEL(4, LEVEL(16, WORK(2), v |= 8), LEVEL(2, v *= 7, WORK(4))))
  x[id + get_global_size(0)] = v;
}
