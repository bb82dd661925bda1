#include "core/candidate_census.hpp"

#include <algorithm>
#include <span>

#include "core/collision_grid.hpp"

namespace warpgrain {

CandidateCensus candidate_census(const Scene& scene) {
  const ParticleState& particles = scene.particles;
  CandidateCensus census;
  if (particles.size() == 0) return census;
  CollisionGrid grid(make_grid_geometry(scene));
  grid.build(std::span<const Vector3<double>>(particles.position));
  std::uint64_t candidates = 0, contacts = 0;
  for (std::uint32_t i = 0; i < particles.size(); ++i) {
    std::uint32_t near = 0, touching = 0;
    grid.for_each_near(cell_coordinates(grid.geometry(), particles.position[i]), [&](std::uint32_t j) {
      if (i == j) return;
      ++near;
      const double reach = particles.radius[i] + particles.radius[j];
      if ((particles.position[i] - particles.position[j]).squaredNorm() < reach * reach) ++touching;
    });
    candidates += near;
    contacts += touching;
    census.most_candidates = std::max(census.most_candidates, near);
    census.most_contacts = std::max(census.most_contacts, touching);
  }
  const auto n = static_cast<double>(particles.size());
  census.mean_candidates = static_cast<double>(candidates) / n;
  census.mean_contacts = static_cast<double>(contacts) / n;
  return census;
}

}  // namespace warpgrain
