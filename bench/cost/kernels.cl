// Kernels that each spend their time in one way, to measure what that way costs a device: what the constants of
// analysis/cost_model.hpp are fitted on. Trip counts are arguments, so that no compiler can work a loop out.

uint hash(uint x) {
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  return x ^ (x >> 16);
}

// Launching.
kernel void nothing(global float* out, uint trips) {
  if (trips > 1000000u) out[get_global_id(0)] = 0;
}

// Arithmetic: each result needs the one before, or eight do not need each other.
kernel void multiply_add_chain(global float* out, uint trips, float a) {
  float x = get_global_id(0);
  for (uint t = 0; t < trips; ++t) {
    x = fma(x, a, 1.0f);
    x = fma(x, a, 2.0f);
    x = fma(x, a, 3.0f);
    x = fma(x, a, 4.0f);
  }
  out[get_global_id(0)] = x;
}
kernel void multiply_adds(global float* out, uint trips, float a) {
  float8 x = (float)get_global_id(0) + (float8)(0, 1, 2, 3, 4, 5, 6, 7);
  for (uint t = 0; t < trips; ++t) {
    x = fma(x, (float8)(a), (float8)(1));
    x = fma(x, (float8)(a), (float8)(2));
  }
  x.lo += x.hi;
  x.lo.lo += x.lo.hi;
  out[get_global_id(0)] = x.s0 + x.s1;
}
kernel void integers(global uint* out, uint trips) {
  uint x = get_global_id(0);
  for (uint t = 0; t < trips; ++t) x = hash(x);
  out[get_global_id(0)] = x;
}
kernel void doubles(global double* out, uint trips, double a) {
  double x = get_global_id(0), y = x + 1;
  for (uint t = 0; t < trips; ++t) {
    x = fma(x, a, 1.0);
    y = fma(y, a, 2.0);
  }
  out[get_global_id(0)] = x + y;
}

// The special-function units.
kernel void root_chain(global float* out, uint trips) {
  float x = get_global_id(0) + 1;
  for (uint t = 0; t < trips; ++t) x = native_rsqrt(x + 0.5f);
  out[get_global_id(0)] = x;
}
kernel void roots(global float* out, uint trips) {
  float4 x = (float)get_global_id(0) + (float4)(1, 2, 3, 4);
  for (uint t = 0; t < trips; ++t) {
    x.x = native_rsqrt(x.x + 0.5f);
    x.y = native_rsqrt(x.y + 0.5f);
    x.z = native_rsqrt(x.z + 0.5f);
    x.w = native_rsqrt(x.w + 0.5f);
  }
  out[get_global_id(0)] = x.x + x.y + x.z + x.w;
}
kernel void divisions(global float* out, uint trips, float a) {
  float x = get_global_id(0);
  for (uint t = 0; t < trips; ++t) x = (x + 1) / (x + a);
  out[get_global_id(0)] = x;
}

// Memory, one after another: each index needs the value before. `mask` is the table's size less one.
kernel void chase(global uint* out, global const uint* table, uint mask, uint trips) {
  uint x = hash(get_global_id(0)) & mask;
  for (uint t = 0; t < trips; ++t) x = hash(table[x] + t) & mask;
  out[get_global_id(0)] = x;
}
// The same by the whole warp at one place.
kernel void chase_uniform(global uint* out, global const uint* table, uint mask, uint trips) {
  uint x = hash(get_group_id(0)) & mask;
  for (uint t = 0; t < trips; ++t) x = hash(table[x] + t) & mask;
  out[get_global_id(0)] = x;
}
// Side by side: four loads that do not need each other.
kernel void gather(global float* out, global const float4* table, uint mask, uint trips) {
  float4 sum = 0;
  for (uint t = 0; t < trips; ++t) {
    const uint x = get_global_id(0) * 7919u + 4 * t;
    sum += table[hash(x) & mask] + table[hash(x + 1) & mask] + table[hash(x + 2) & mask] + table[hash(x + 3) & mask];
  }
  out[get_global_id(0)] = sum.x + sum.y + sum.z + sum.w;
}
kernel void copy(global float* out, global const float* in, uint n) {
  for (uint i = get_global_id(0); i < n; i += get_global_size(0)) out[i] = in[i] + 1;
}
// Neighbours in memory, as bodies that lie near each other have.
kernel void neighbours(global float* out, global const float4* table, uint mask, uint trips) {
  const float4 own = table[get_global_id(0) & mask];
  float sum = 0;
  for (uint t = 0; t < trips; ++t) {
    const float4 to = table[(get_global_id(0) + hash(t) % 4096u) & mask] - own;
    sum += to.x * to.x + to.y * to.y + to.z * to.z;
  }
  out[get_global_id(0)] = sum;
}
// Each lane walks along a line of its own.
kernel void rows(global float* out, global const float* table, uint trips) {
  global const float* row = table + (size_t)get_global_id(0) * 32;
  float sum = 0;
  for (uint t = 0; t < trips; ++t) sum = fma(sum, 0.5f, row[t & 31]);
  out[get_global_id(0)] = sum;
}
kernel void scatter(global float* out, uint mask, uint trips) {
  for (uint t = 0; t < trips; ++t) out[hash(get_global_id(0) * 64u + t) & mask] = t;
}
kernel void add_atomically(global uint* out, uint mask, uint trips) {
  for (uint t = 0; t < trips; ++t) atomic_add(out + (hash(get_global_id(0) * 64u + t) & mask), t);
}

// Local memory and barriers; `tile` limits how many work-groups a multiprocessor holds.
kernel void exchange(global float* out, uint trips, local float* tile) {
  float x = get_global_id(0);
  for (uint t = 0; t < trips; ++t) {
    tile[get_local_id(0)] = x;
    barrier(CLK_LOCAL_MEM_FENCE);
    x = fma(x, 0.5f, tile[(get_local_id(0) + 33) % get_local_size(0)]);
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  out[get_global_id(0)] = x;
}
kernel void few_groups(global uint* out, global const uint* table, uint mask, uint trips, local uint* tile) {
  tile[get_local_id(0)] = hash(get_global_id(0)) & mask;
  uint x = tile[get_local_id(0)];
  for (uint t = 0; t < trips; ++t) x = hash(table[x] + t) & mask;
  out[get_global_id(0)] = x;
}

// Lanes and warps with more to do than others.
kernel void uneven_lanes(global float* out, global const float4* table, uint mask, uint trips) {
  const float4 own = table[get_global_id(0) & mask];
  const uint n = hash(get_global_id(0)) % (2 * trips);
  float sum = 0;
  for (uint t = 0; t < n; ++t) {
    const float4 to = table[(get_global_id(0) + hash(t) % 512u) & mask] - own;
    const float square = to.x * to.x + to.y * to.y + to.z * to.z;
    if ((hash(get_global_id(0) + t) & 7) == 0) sum += native_rsqrt(square + 1) / (sum + square + 2);
  }
  out[get_global_id(0)] = sum;
}
kernel void uneven_warps(global float* out, global const float4* table, uint mask, uint trips) {
  const uint warp = get_global_id(0) / 32;
  const uint n = trips >> (hash(warp) % 5);
  float4 sum = table[get_global_id(0) & mask];
  for (uint t = 0; t < n; ++t) sum = fma(sum, (float4)(0.5f), table[(get_global_id(0) + hash(warp + t) % 4096u) & mask]);
  out[get_global_id(0)] = sum.x + sum.y + sum.z + sum.w;
}

// Slots of a row for each lane, as contact histories have them: 16 of 32 bytes at a time. `spread` lanes have
// different numbers of them.
kernel void slots(global float4* out, global const float4* in, uint slots_a_lane, uint trips) {
  for (uint t = 0; t < trips; ++t) {
    const size_t slot = (size_t)get_global_id(0) * slots_a_lane + t;
    out[slot] = in[slot] + 1.0f;
  }
}
kernel void uneven_slots(global float4* out, global const float4* in, uint slots_a_lane, uint trips) {
  const uint n = hash(get_global_id(0)) % (trips + 1);
  for (uint t = 0; t < n; ++t) {
    const size_t slot = (size_t)get_global_id(0) * slots_a_lane + t;
    out[slot] = in[slot] + 1.0f;
  }
}
// One slot of each lane moves to another row.
kernel void moved_slots(global float4* out, global const float4* in, uint slots_a_lane, uint trips, uint mask) {
  const size_t from = (size_t)(hash(get_global_id(0)) & mask) * slots_a_lane;
  for (uint t = 0; t < trips; ++t) out[(size_t)get_global_id(0) * slots_a_lane + t] = in[from + t];
}
kernel void fill(global float4* out, uint n) {
  for (uint i = get_global_id(0); i < n; i += get_global_size(0)) out[i] = (float4)(i);
}
