// A loop over the byte code of a small stack machine; each work-item has another program counter history.
kernel void interpreter(global const uchar* program, uint length, global int* results) {
  int stack[8];
  for (uint k = 0; k < 8; ++k) stack[k] = (int)get_global_id(0) + (int)k;
  uint top = 2;
  for (uint counter = get_global_id(0) % 7, step = 0; counter < length && step < 60; ++step) {
    const uint word = program[counter++];
    switch (word % 8) {
      case 0:
        stack[top & 7] = (int)(word >> 3);
        ++top;
        break;
      case 1:
        stack[(top - 2) & 7] += stack[(top - 1) & 7];
        --top;
        break;
      case 2:
        stack[(top - 2) & 7] *= stack[(top - 1) & 7] | 1;
        --top;
        break;
      case 3:
        stack[(top - 1) & 7] ^= stack[(top - 2) & 7];
        break;
      case 4:
        if (stack[(top - 1) & 7] & 4) counter += word >> 6;
        break;
      case 5:
        stack[top & 7] = stack[(top - 1) & 7] >> 1;
        ++top;
        break;
      case 6:
        if (stack[(top - 1) & 7] % 3 == 0) counter = counter * 5 % length;
        break;
      default:
        stack[(top - 1) & 7] = -stack[(top - 1) & 7];
        break;
    }
  }
  results[get_global_id(0)] = stack[(top - 1) & 7];
}
