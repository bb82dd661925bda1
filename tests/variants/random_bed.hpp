#pragma once
// Fresh beds for tests: particles that overlap each other, walls, edges and corners, in several materials and
// radii, with random motion and a random history, parts of it of contacts that no longer touch.

#include <cstddef>
#include <cstdint>

#include "core/scene.hpp"

namespace warpgrain {

struct BedOptions {
  std::size_t n_particles = 500;
  std::uint64_t seed = 1;
  double spacing = 1.9;  // of the lattice before it is shaken, in largest radii
  bool history = true;
};

// Radius 4 to 5 mm, two materials; neither ids nor places in the arrays say anything about where a particle
// is.
Scene random_bed(const BedOptions& options);

}  // namespace warpgrain
