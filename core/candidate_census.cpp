#include "core/candidate_census.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "core/collision_grid.hpp"

namespace warpgrain {

NeighbourCounts neighbour_counts(const Scene& scene) {
  const ParticleState& particles = scene.particles;
  NeighbourCounts counts;
  if (particles.size() == 0) return counts;
  CollisionGrid grid(make_grid_geometry(scene));
  grid.build(std::span<const Vector3<double>>(particles.position));
  for (std::uint32_t i = 0; i < particles.size(); ++i) {
    std::uint32_t near = 0, touching = 0;
    grid.for_each_near(cell_coordinates(grid.geometry(), particles.position[i]), [&](std::uint32_t j) {
      if (i == j) return;
      ++near;
      const double reach = particles.radius[i] + particles.radius[j];
      if ((particles.position[i] - particles.position[j]).squaredNorm() < reach * reach) ++touching;
    });
    counts.candidates.push_back(near);
    counts.contacts.push_back(touching);
  }
  return counts;
}

CandidateCensus candidate_census(const Scene& scene) {
  const NeighbourCounts counts = neighbour_counts(scene);
  CandidateCensus census;
  if (counts.candidates.empty()) return census;
  const auto mean = [](const std::vector<std::uint32_t>& values) {
    return static_cast<double>(std::accumulate(values.begin(), values.end(), std::uint64_t{0})) /
           static_cast<double>(values.size());
  };
  census.mean_candidates = mean(counts.candidates);
  census.most_candidates = *std::ranges::max_element(counts.candidates);
  census.mean_contacts = mean(counts.contacts);
  census.most_contacts = *std::ranges::max_element(counts.contacts);
  return census;
}

}  // namespace warpgrain
