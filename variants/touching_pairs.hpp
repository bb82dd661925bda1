#pragma once
// The parameters of all contacts that a scene can have.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/scene.hpp"

namespace warpgrain {

// Of each pair of materials that may touch, two particles or a particle and a wall. A material that one
// particle alone has never touches itself.
struct TouchingPairs {
  explicit TouchingPairs(const Scene& scene) {
    std::vector<std::size_t> count(scene.contacts.n_materials(), 0);
    for (const std::uint32_t material : scene.particles.material) ++count[material];
    for (std::size_t a = 0; a < count.size(); ++a) {
      if (count[a] == 0) continue;
      for (std::size_t b = a; b < count.size(); ++b)
        if (count[b] > (a == b ? 1u : 0u)) of_particles.push_back(scene.contacts.at(a, b));
      for (const Wall& wall : scene.walls) of_walls.push_back(scene.contacts.at(a, wall.material));
    }
  }

  bool any(const std::function<bool(const ContactParameters&)>& has) const {
    return std::ranges::any_of(of_particles, has) || std::ranges::any_of(of_walls, has);
  }

  std::vector<ContactParameters> of_particles, of_walls;
};

}  // namespace warpgrain
