// Where a pattern stands in a text, every place tried; most fail at the first letters.
kernel void string_search(global const uchar* text, uint length, global const uchar* pattern, uint n,
                          global uint* found) {
  const uint begin = get_global_id(0);
  if (begin + n > length) return;
  uint k = 0;
  while (k < n && (text[begin + k] & 3) == pattern[k]) ++k;
  found[begin] = k == n ? 1 : 0;
}
