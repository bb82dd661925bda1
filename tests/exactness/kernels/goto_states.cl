// A state machine whose states jump to each other.
kernel void goto_states(global const uint* in, global uint* out) {
  const uint id = get_global_id(0);
  uint x = in[id] * 2654435761u, steps = 0;
start:
  if (++steps > 40) goto end;
  if (x & 1) goto odd;
  x >>= 1;
  if (x % 5 == 0) goto five;
  goto start;
odd:
  x = x * 3 + 1;
  if (x & 0x40) goto start;
  if (steps > 30) goto end;
five:
  x ^= steps << 5;
  if (x & 6) goto start;
  x += 13;
  if (x & 8) goto odd;
end:
  out[id] = x + steps;
}
