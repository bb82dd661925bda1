// The forces between particles, a warp a block of cells: its lanes take the particles of the block, and all
// of them walk the same cells, those of the block and around it. Candidates come through local memory, each
// loaded once for all lanes, and no lane waits for another's longer row of cells; the price is that each lane
// tests all candidates of the block, not those of its own 27 cells. Contacts are listed, the law follows.

#include "contact/contact_law.h"
#include "grid.h"
#include "pair.h"
#include "particle_access.h"
#include "prelude.h"
#include "search/candidates.h"
#include "search/numbering.h"

// A box of cells; parts of it may be beyond the grid.
typedef struct {
  int x, y, z;
  uint n_x, n_y, n_z;
} Cells;

// Cells beside each other along x are one stretch of the sorted map, unless they follow a Morton curve.
#if ORDER_MORTON
DEVICE_FUNCTION uint stretches_of(Cells cells) { return cells.n_x * cells.n_y * cells.n_z; }
#else
DEVICE_FUNCTION uint stretches_of(Cells cells) { return cells.n_y * cells.n_z; }
#endif

DEVICE_FUNCTION uint2 stretch_in(const StepParameters p, Cells cells, uint number,
                                 GLOBAL const uint2* cell_ranges) {
#if ORDER_MORTON
  const int x = cells.x + (int)(number % cells.n_x);
  const uint row = number / cells.n_x, n_x = 1;
#else
  const int x = cells.x;
  const uint row = number, n_x = cells.n_x;
#endif
  const int y = cells.y + (int)(row % cells.n_y), z = cells.z + (int)(row / cells.n_y);
  const bool inside =
      y >= 0 && y < (int)p.cells_y && z >= 0 && z < (int)p.cells_z && row / cells.n_y < cells.n_z;
  if (!inside) return make_uint2(0, 0);
  return stretch_of(p, x, n_x, y, z, cell_ranges);
}

// Numbers through what stretches `first` and the 31 after it hold: begins and ends [CELL_WORK_GROUP].
// Returns how much that is.
DEVICE_FUNCTION uint number_stretches(const StepParameters p, Cells cells, uint first, uint item,
                                      LOCAL_POINTER uint* begins, LOCAL_POINTER uint* ends,
                                      GLOBAL const uint2* cell_ranges) {
  const uint2 stretch = stretch_in(p, cells, first + item, cell_ranges);
  work_group_barrier_local();  // what was there has been read
  begins[item] = stretch.x;
  ends[item] = stretch.y - stretch.x;
  work_group_barrier_local();
  sum_up(ends, item, CELL_WORK_GROUP);
  return ends[CELL_WORK_GROUP - 1];
}

DEVICE_FUNCTION uint place_of(uint number, LOCAL_POINTER const uint* begins, LOCAL_POINTER const uint* ends) {
  const uint owner = owner_of(number, ends, CELL_WORK_GROUP);
  return begins[owner] + number_within(number, owner, ends);
}

KERNEL WORK_GROUP_OF(CELL_WORK_GROUP) void force_between_particles(
    const StepParameters p MAP_PARAMETER, GLOBAL const uint2* cell_ranges, GLOBAL uint* near,
    PARTICLE_PARAMETERS MATERIAL_PARAMETER, SUM_PARAMETERS, GLOBAL uint2* contact_counts,
    GLOBAL uint* status HISTORY_PARAMETERS) {
  LOCAL uint begins[CELL_WORK_GROUP], ends[CELL_WORK_GROUP], candidates[CELL_WORK_GROUP];
  LOCAL Place places[CELL_WORK_GROUP];
  const Particles particles = PARTICLES;
  const Sums sums = SUMS;
  const LawParameters law = LAW_PARAMETERS(p, of_pairs);
  const uint item = work_item_in_group(), block = work_group();
  const uint blocks_x = (p.cells_x + BLOCK_X - 1) / BLOCK_X, blocks_y = (p.cells_y + BLOCK_Y - 1) / BLOCK_Y;
  const Cells own = {(int)(block % blocks_x * BLOCK_X),
                     (int)(block / blocks_x % blocks_y * BLOCK_Y),
                     (int)(block / blocks_x / blocks_y * BLOCK_Z),
                     BLOCK_X,
                     BLOCK_Y,
                     BLOCK_Z};
  const Cells around = {own.x - 1, own.y - 1, own.z - 1, BLOCK_X + 2, BLOCK_Y + 2, BLOCK_Z + 2};

  uint n_own = 1;
  for (uint first_own = 0; first_own < n_own; first_own += CELL_WORK_GROUP) {  // branch: next particles
    n_own = number_stretches(p, own, 0, item, begins, ends, cell_ranges);
    const bool exists = first_own + item < n_own;
    uint self = 0, n_contacts = 0;
    if (exists) self = particle_at(place_of(first_own + item, begins, ends) MAP_ARGUMENT);
    const Particle particle = load_particle(p, self, &particles);

    const uint n_stretches = n_own > 0 ? stretches_of(around) : 0;
    for (uint first_stretch = 0; first_stretch < n_stretches; first_stretch += CELL_WORK_GROUP) {
      const uint n_candidates = number_stretches(p, around, first_stretch, item, begins, ends, cell_ranges);
      for (uint first = 0; first < n_candidates; first += CELL_WORK_GROUP) {  // branch: next candidates
        if (first + item < n_candidates) {                                    // branch: loads a candidate
          candidates[item] = particle_at(place_of(first + item, begins, ends) MAP_ARGUMENT);
          places[item] = position_radius[candidates[item]];
        }
        work_group_barrier_local();
        const uint n = min(n_candidates - first, (uint)CELL_WORK_GROUP);
        uint touching = 0;
        for (uint k = 0; k < n; ++k) {  // branch: next candidate
          const Pair pair = pair_with(particle.place, places[k]);
          touching |= touches(&pair) && candidates[k] != self ? 1u << k : 0;  // branch: contact test
        }
        if (!exists) touching = 0;
        while (touching != 0) {           // branch: next touching
          if (n_contacts < LIST_SLOTS) {  // branch: list full
            near[n_contacts * p.n_particles + self] = candidates[lowest_bit(touching)];
          }
          touching &= touching - 1;
          ++n_contacts;
        }
        work_group_barrier_local();
      }
    }

    if (exists) {  // branch: a particle
      n_contacts = checked_length(n_contacts, &particle, status);
      ContactHistory history = HISTORY_OF(self, particle.rank, 0);
      ForceSum sum = gravity_alone(p, particle.mass);
      apply_to_listed(p, self, &particle, n_contacts, near, &particles, &law, &history, &sum);
      store_sum(self, &particles, &sum, n_contacts, &sums, contact_counts, status);
    }
  }
}
