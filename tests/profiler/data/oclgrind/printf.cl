// Every conversion, length and vector of printf, before and behind a barrier.
kernel void print(global int* a, global const float* f) {
  const int i = get_global_id(0);
  const char4 c = (char4)(1, -2, 3, 4);
  const uchar2 u = (uchar2)(200, 3);
  const short3 s = (short3)(1, -2, 3);
  const long2 l = (long2)(-1, 5);
  const double3 d = (double3)(1.5, 2, 3);
  printf("[%5d|%-5d|%05d|%+d|% d|%x|%#x|%X|%o|%u|%c|%%|%i]\n", i, i, i, i, i, i + 10, i + 10, i + 10, i + 10, -1, 'a' + i, 7);
  printf("[%f|%e|%g|%a|%.2f|%10.3f|%F|%G|%E]\n", f[0], f[1], f[2], f[3], f[0], f[0], f[0], f[1], f[2]);
  printf("[%v4hhd|%v2hhu|%v3hd|%v2ld|%v3lf|%v4hlf|%v2hlx]\n", c, u, s, l, d, (float4)(1, 2, f[0], -0.0f), (int2)(17, -1));
  printf("[%v4hlg|%8.2v4hlf|%v8hld]\n", (float4)(1e10f, INFINITY, -INFINITY, .1f), (float4)(i), (int8)(1, 2, 3, 4, 5, 6, 7, i));
  printf("[%ld|%lu|%lx|%hd|%hhd|%hhu|%hu]\n", (long)i - 5, 1ul << 63, -1l, (short)-7, (char)-8, (uchar)250, (ushort)65535);
  printf("[%s|%10s|%-10s|%.2s]\n", "abc", "abc", i == 2 ? "two" : "not two", "abc");
  barrier(CLK_LOCAL_MEM_FENCE);
  if (i & 1) printf("odd %d of group %v2d\n", i, (int2)((int)get_group_id(0), (int)get_num_groups(0)));
  a[i] = printf("done\n");
}
