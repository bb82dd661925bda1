#pragma once
// The particles of a profiled step, for a drawing: where they lie, whom they touch, and how well the warp ran
// that had each.

#include <cstdint>
#include <string>
#include <vector>

namespace warpgrain::reports {

struct Bed {
  std::uint64_t particles = 0;  // of the scene; more than are listed: these are a slab through the middle
  std::string slab;             // what they are then: "the 20,000 nearest to x = 0.21 m"
  std::string kernel;           // whose warps; empty where its work-items are not particle by particle
  double unit = 0;              // m: of the lengths below
  std::int64_t box[2][3] = {};  // around the scene's particles
  // Particle by particle, in the order of the warps. Lengths in `unit`.
  std::vector<std::int64_t> x, y, z;
  std::vector<std::int64_t> radius;       // one where all have the same
  std::vector<std::uint64_t> contacts;    // with other particles
  std::vector<std::uint64_t> candidates;  // other particles in the 27 cells
  std::vector<std::uint64_t> warp;        // its number; empty without a kernel, as the next
  std::vector<double> efficiency;         // SIMT efficiency of that warp, in 1/1000 at most
};

}  // namespace warpgrain::reports
