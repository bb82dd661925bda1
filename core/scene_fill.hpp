#pragma once
// Many equal particles from a few numbers: a jittered lattice that fills a box and never overlaps.

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/scene.hpp"

namespace warpgrain {

struct FillSpec {
  Box box;
  std::uint64_t count = 0;
  double radius = 0;  // m
  std::uint64_t seed = 1;
};

// Whether the lattice below holds `count` spheres.
bool fits(const FillSpec& fill);

// Centres of `count` spheres that lie inside the box without touching, [count], in random order; the layers
// are filled from below. The lattice is the widest one that holds them; each sphere is moved within its
// lattice cell at random, the same on every machine for the same seed. Throws InputError naming `where` when
// they do not fit.
std::vector<Vector3d> fill_positions(const FillSpec& fill, std::string_view where);

}  // namespace warpgrain
