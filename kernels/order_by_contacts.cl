// The order `contact_count` of particles in memory: that of cells, and within windows of it by the number of
// partners that each touched last, so that the lanes of a warp have as many contacts, while what they touch
// is still near in memory.

#include "prelude.h"
#include "sort/exchange.h"

#define ORDER_WINDOW (2 * ORDER_WORK_GROUP)

// Particles of one count stay in the order of the sorted map; places beyond the last particle come last.
DEVICE_FUNCTION ulong contacts_and_place(const StepParameters p, uint place, GLOBAL const ulong* cell_keys,
                                         GLOBAL const uint* particle_of_rank,
                                         GLOBAL const uint2* contact_counts) {
  if (place >= p.n_particles) return ~(ulong)0;
  return (ulong)contact_counts[particle_of_rank[(uint)cell_keys[place]]].x << 32 | place;
}

// memory_keys [n_particles]: the keys of the map in the order in which particles will stand in memory.
KERNEL WORK_GROUP_OF(ORDER_WORK_GROUP) void order_by_contacts(const StepParameters p,
                                                              GLOBAL const ulong* cell_keys,
                                                              GLOBAL const uint* particle_of_rank,
                                                              GLOBAL const uint2* contact_counts,
                                                              GLOBAL ulong* memory_keys) {
  LOCAL ulong block[ORDER_WINDOW];
  const uint item = work_item_in_group(), base = work_group() * ORDER_WINDOW;
  for (uint k = item; k < ORDER_WINDOW; k += ORDER_WORK_GROUP)
    block[k] = contacts_and_place(p, base + k, cell_keys, particle_of_rank, contact_counts);
  sort_block(block, 0, ORDER_WINDOW);
  for (uint k = item; k < ORDER_WINDOW; k += ORDER_WORK_GROUP)
    if (base + k < p.n_particles) memory_keys[base + k] = cell_keys[(uint)block[k]];
}
