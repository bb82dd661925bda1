// Whether lists with a skin may still be used: of the searches whose lists outlive a step.

#include "grid.h"
#include "place.h"
#include "prelude.h"
#include "status.h"

// Whether the lists may miss a contact: both partners may have moved towards each other, by half the skin
// each, less some room for rounding. Written so that a NaN makes it so.
KERNEL void check_lists(const StepParameters p, GLOBAL const Place* position_radius,
                        GLOBAL const Identity* rank_material, GLOBAL const Place* listed_positions,
                        GLOBAL uint* lists_outdated, GLOBAL uint* status) {
  const uint particle = work_item();
  if (particle >= p.n_particles) return;  // branch: beyond the last particle
  is_inside(p, position_radius[particle], rank_in(rank_material[particle]), status);
  const real3 moved = way_between(listed_positions[particle], position_radius[particle]);
  const real limit = REAL(0.49) * p.skin;
  if (!(dot(moved, moved) < limit * limit)) atomic_max(lists_outdated, 1u);  // branch: moved far
}
