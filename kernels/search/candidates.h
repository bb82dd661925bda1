// The walk over the candidates of a particle, and lists of those that are near enough: written once for the
// searches that list before they apply a law. Where cells beside each other along x are beside each other in
// the sorted map, the 27 cells are nine stretches of it.
#ifndef WARPGRAIN_CANDIDATES_H
#define WARPGRAIN_CANDIDATES_H

#include "grid.h"
#include "pair.h"
#include "prelude.h"
#include "status.h"

// Partners that a particle's list holds.
#ifndef LIST_SLOTS
#define LIST_SLOTS 16
#endif

// Stretches of the sorted map in a row of three cells, and how many cells each has.
#if ORDER_MORTON
#define STRETCHES 3
#define STRETCH_CELLS 1
#else
#define STRETCHES 1
#define STRETCH_CELLS 3
#endif

// The stretch of n_x cells that begins with cell x, y, z; x may be beyond the grid.
DEVICE_FUNCTION uint2 stretch_of(const StepParameters p, int x, int n_x, int y, int z,
                                 GLOBAL const uint2* cell_ranges) {
  uint end = 0, n = 0;
  for (int k = 0; k < n_x; ++k) {
    const bool inside = x + k >= 0 && x + k < (int)p.cells_x;
    const uint2 range = cell_ranges[cell_number(p, inside ? x + k : 0, y, z)];
    end = max(end, inside ? range.y : 0);
    n += inside ? range.y - range.x : 0;
  }
  return make_uint2(end - n, end);
}

DEVICE_FUNCTION uint2 stretch_from(const StepParameters p, int x, int y, int z,
                                   GLOBAL const uint2* cell_ranges) {
  return stretch_of(p, x, STRETCH_CELLS, y, z, cell_ranges);
}

// What fits of a list of that length; that it does not is an error of the run.
DEVICE_FUNCTION uint checked_length(uint length, const Particle* particle, GLOBAL uint* status) {
  if (length <= LIST_SLOTS) return length;
  report_error(status, STATUS_LIST_FULL, particle->rank);
  return LIST_SLOTS;
}

// Lists the other particles whose surface is nearer than `skin`, in the order of the sorted map: entry k of
// particle i at near[k * n_particles + i], so that a warp's lanes write side by side. Returns how many there
// are.
DEVICE_FUNCTION uint list_near(const StepParameters p, uint self, const Particle* particle,
                               real skin MAP_PARAMETER, GLOBAL const uint2* cell_ranges,
                               GLOBAL const Place* position_radius, GLOBAL uint* near, GLOBAL uint* status) {
  uint n_near = 0;
  const Cell cell = cell_at(p, position_radius[self]);
  for (int z = max(cell.z - 1, 0); z <= min(cell.z + 1, (int)p.cells_z - 1); ++z) {    // branch: next layer
    for (int y = max(cell.y - 1, 0); y <= min(cell.y + 1, (int)p.cells_y - 1); ++y) {  // branch: next row
      for (int s = 0; s < STRETCHES; ++s) {
        const uint2 stretch = stretch_from(p, cell.x - 1 + s, y, z, cell_ranges);
        for (uint place = stretch.x; place < stretch.y; ++place) {  // branch: next candidate
          const uint other = particle_at(place MAP_ARGUMENT);
          const Pair pair = pair_with(particle->place, position_radius[other]);
          const bool is_near = is_within(&pair, skin) && other != self;
          if (is_near && n_near < LIST_SLOTS) {  // branch: near enough
            near[n_near * p.n_particles + self] = other;
          }
          n_near += is_near ? 1 : 0;
        }
      }
    }
  }
  return checked_length(n_near, particle, status);
}

// Applies the law to the listed partners, one after the other.
DEVICE_FUNCTION void apply_to_listed(const StepParameters p, uint self, const Particle* particle,
                                     uint n_contacts, GLOBAL const uint* near, const Particles* particles,
                                     const LawParameters* law, ContactHistory* history, ForceSum* sum) {
  for (uint k = 0; k < n_contacts; ++k) {  // branch: next contact
    const uint other = near[k * p.n_particles + self];
    const Pair pair = pair_with(particle->place, particles->position_radius[other]);
    const Contact contact = contact_of(particle, &pair, other, particles);
    apply_contact(law, particle, &contact, history, sum);
  }
}

#endif
