#pragma once
// The fixed point in which precision `mixed` keeps places on a device (kernels/place.h).

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/scene.hpp"

namespace warpgrain {

// A unit is 2^unit_exponent metres. No place of a scene is farther than 2^61 units from the origin: units are
// finer than the doubles of states are far from it, so that states go to a device and back as they are, and
// so that no step is lost that is longer than 2^-62 of that, however slow a particle creeps.
struct FixedPoint {
  int unit_exponent = 0;
  int coarse_shift = 0;  // coarse parts of lengths between neighbours are in 2^coarse_shift units

  // To the nearest unit; INT64_MIN of what is not a number, and within 2^62 of what is far outside.
  std::int64_t units(double length) const;
  double length(std::int64_t units) const;
  // -D options of the kernels.
  std::string build_options() const;
};

// The finest for the scene's domain and walls. `cell_edge` [m] is the collision grid's. Throws InputError
// where doubles, which states are made of, resolve less of the smallest radius than floats do: 2^24 parts.
FixedPoint fixed_point_for(const Scene& scene, double cell_edge);

// position_radius: x, y, z, radius a particle.
std::vector<std::byte> fixed_places(const ParticleState& particles, const FixedPoint& fixed_point);
// layout::FixedWallLayout a wall; one where there is none.
std::vector<std::byte> fixed_wall_rows(const std::vector<Wall>& walls, const FixedPoint& fixed_point);

}  // namespace warpgrain
