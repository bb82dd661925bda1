// Sixteen cases without a gap: a table of jumps.
kernel void dense_switch(global const uint* in, global const float* more, global float* out) {
  const uint id = get_global_id(0);
  const uint value = in[id] * 2654435761u;
  float x = (float)id;
  switch (value >> 28) {
    case 0:
      x = x * 3 + 1;
      break;
    case 1:
      x = x - 7 * x * x;
      break;
    case 2:
      x = native_sqrt(x);
      break;
    case 3:
      x = x / 3 + more[id];
      break;
    case 4:
      x = native_exp(-x);  // falls through
    case 5:
      x += 5;
      break;
    case 6:
      x = native_sin(x) * x;
      break;
    case 7:
      x = fabs(x - 100);
      break;
    case 8:
      x = x > 50 ? 1 / x : x;
      break;
    case 9:
      x = -x;
      break;
    case 10:
      x = x * x;  // falls through
    case 11:
      x = x + more[id ^ 1];
      break;
    case 12:
      x = native_log(x + 1);
      break;
    case 13:
      x = native_rsqrt(x + 1);
      break;
    case 14:
      x = max(x, 20.0f);
      break;
    default:
      x = 0;
      break;
  }
  out[id] = x;
}
