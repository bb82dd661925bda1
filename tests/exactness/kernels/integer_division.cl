// Division and remainder by numbers that are not known ahead, of 32 and 64 bits.
kernel void integer_division(global const uint* in, global ulong* out) {
  const uint id = get_global_id(0);
  const uint a = in[id] * 2654435761u, b = in[id ^ 5] % 1000 + 1;
  ulong x = a / b + a % b;
  x += (int)a / -(int)b;
  if (id & 2) x = (x << 20 | a) / ((ulong)b << (id & 31));
  out[id] = x;
}
