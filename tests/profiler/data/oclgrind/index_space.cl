// All that tells a work-item where it is, in three dimensions.
kernel void index_space(global uint* a) {
  const size_t i = (get_global_id(2) * get_global_size(1) + get_global_id(1)) * get_global_size(0) + get_global_id(0);
  a[i] = get_local_id(0) + 10 * get_local_id(1) + 100 * get_local_id(2) + 1000 * get_group_id(0) +
         10000 * get_group_id(1) + 100000 * get_group_id(2) + get_work_dim() * 1000000 + get_global_offset(0) +
         get_num_groups(0) * get_num_groups(1) * get_num_groups(2) * 10000000 + get_local_size(1) * 100000000 +
         get_local_size(5) + get_global_id(7);
}
