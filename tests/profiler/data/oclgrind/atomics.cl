// Every atomic of 32 bits on global and local memory; one work-item a group keeps the old values.
kernel void atomics(global int* a, global uint* b, global float* f, global int* old) {
  local int l;
  local uint u;
  const int i = get_global_id(0);
  if (get_local_id(0) == 0) l = 5, u = 7;
  barrier(CLK_LOCAL_MEM_FENCE);
  atomic_add(&a[0], i);
  atomic_sub(&a[1], i);
  atomic_inc(&a[2]);
  atomic_dec(&a[3]);
  atomic_min(&a[4], -i);
  atomic_max(&a[5], i);
  atomic_and(&b[0], ~(1u << i));
  atomic_or(&b[1], 1u << i);
  atomic_xor(&b[2], 3u << i);
  atomic_min(&b[3], 100u - i);
  atomic_max(&b[4], 100u + i);
  atom_add(&l, i);
  atom_max(&u, 1u << i);
  if (i == 3) {
    old[0] = atomic_xchg(&a[6], 17);
    old[1] = atomic_cmpxchg(&a[6], 17, 18);
    old[2] = atomic_cmpxchg(&a[6], 17, 19);
    old[3] = as_int(atomic_xchg(&f[0], 2.5f));
    old[4] = atom_cmpxchg(&b[5], 4u, 6u);
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  a[8 + get_group_id(0)] = l;
  b[6 + get_group_id(0)] = u;
}
