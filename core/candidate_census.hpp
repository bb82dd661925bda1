#pragma once
// What a search through the 27 cells around each particle finds: other particles, and those of them that
// touch.

#include <cstdint>
#include <vector>

#include "core/scene.hpp"

namespace warpgrain {

struct CandidateCensus {
  double mean_candidates = 0;  // other particles in the 27 cells, a particle
  std::uint32_t most_candidates = 0;
  double mean_contacts = 0;  // of these, those that overlap it; walls do not count
  std::uint32_t most_contacts = 0;
};

struct NeighbourCounts {
  std::vector<std::uint32_t> candidates, contacts;  // as above, [n_particles]
};

// Of the scene's particles as they are, in the grid of make_grid_geometry(scene). Empty or zero without
// particles. Throws InputError when the scene has no usable domain.
NeighbourCounts neighbour_counts(const Scene& scene);
CandidateCensus candidate_census(const Scene& scene);

}  // namespace warpgrain
