#pragma once
// Candidate contact partners of each particle: all other particles and walls nearer than touching by a skin.
// With a skin the list stays complete until some particle has moved half the skin's width, so that a step
// tests few pairs and the grid is rebuilt now and then. The list never changes a result: who touches is
// tested exactly at every step.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/collision_grid.hpp"
#include "core/parallel_ranges.hpp"
#include "core/vector3.hpp"
#include "core/wall.hpp"

namespace warpgrain {

// Partners of the particles of one range: those of particle first + k are partner[row_start[k]] ...
// partner[row_start[k + 1] - 1], in ascending order. A partner is a particle's index, greater than the
// particle's own (each pair is listed once), or wall_partner_bit | wall index.
struct PartnerRows {
  std::vector<std::uint32_t> row_start;  // [range size + 1]
  std::vector<std::uint32_t> partner;
};

template <class Real>
class NeighbourList {
 public:
  // `skin` [m], at least 0; 0 lists the pairs that touch. `ranges` cover the particles.
  NeighbourList(const Box& domain, std::vector<Wall> walls, std::vector<Real> radius, double skin,
                std::vector<IndexRange> ranges);

  // All [n_particles], inside the domain.
  void build(std::span<const Vector3<Real>> positions);
  // Whether a particle has moved so far since the last build that the list may miss a contact.
  bool outdated_by(Real squared_displacement) const { return !(squared_displacement < squared_limit_); }
  std::span<const Vector3<Real>> built_at() const { return built_at_; }

  const std::vector<IndexRange>& ranges() const { return ranges_; }
  const PartnerRows& rows(std::size_t range) const { return rows_[range]; }
  std::uint64_t builds() const { return builds_; }

 private:
  void build_range(std::size_t range);

  std::vector<Wall> walls_;
  std::vector<Real> radius_;
  Real skin_, squared_limit_;
  std::vector<IndexRange> ranges_;
  CollisionGrid grid_;
  std::vector<Vector3<Real>> built_at_;
  std::vector<PartnerRows> rows_;
  std::uint64_t builds_ = 0;
};

}  // namespace warpgrain
