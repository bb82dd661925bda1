#include "core/neighbour_list.hpp"

#include <algorithm>

#include "core/contact_history.hpp"

namespace warpgrain {
namespace {

template <class Real>
CollisionGrid grid_for(const Box& domain, const std::vector<Real>& radius, double skin) {
  const double largest = radius.empty() ? 1.0 : *std::max_element(radius.begin(), radius.end());
  return CollisionGrid(make_grid_geometry(domain, 2 * largest + skin, radius.size()));
}

}  // namespace

template <class Real>
NeighbourList<Real>::NeighbourList(const Box& domain, std::vector<Wall> walls, std::vector<Real> radius,
                                   double skin, std::vector<IndexRange> ranges)
    : walls_(std::move(walls)),
      radius_(std::move(radius)),
      skin_(static_cast<Real>(skin)),
      // Both partners may have moved towards each other, by half the skin each, less some room for rounding.
      squared_limit_(static_cast<Real>(0.49 * skin) * static_cast<Real>(0.49 * skin)),
      ranges_(std::move(ranges)),
      grid_(grid_for(domain, radius_, skin)),
      rows_(ranges_.size()) {}

template <class Real>
void NeighbourList<Real>::build(std::span<const Vector3<Real>> positions) {
  built_at_.assign(positions.begin(), positions.end());
  grid_.build(positions);
  for_each_range(ranges_.size(), [this](std::size_t range) { build_range(range); });
  ++builds_;
}

template <class Real>
void NeighbourList<Real>::build_range(std::size_t range) {
  PartnerRows& rows = rows_[range];
  rows.row_start.assign(1, 0);
  rows.partner.clear();
  for (std::size_t i = ranges_[range].first; i < ranges_[range].last; ++i) {
    const Vector3<Real> position = built_at_[i];
    const Real reach = radius_[i] + skin_;
    grid_.for_each_near(cell_coordinates(grid_.geometry(), position), [&](std::uint32_t j) {
      if (j <= i) return;
      const Real limit = reach + radius_[j];
      if ((built_at_[j] - position).squaredNorm() < limit * limit) rows.partner.push_back(j);
    });
    std::sort(rows.partner.begin() + rows.row_start.back(), rows.partner.end());
    for (std::uint32_t w = 0; w < walls_.size(); ++w)
      if (wall_proximity(walls_[w], position.template cast<double>()).distance < reach)
        rows.partner.push_back(wall_partner_bit | w);
    rows.row_start.push_back(static_cast<std::uint32_t>(rows.partner.size()));
  }
}

template class NeighbourList<float>;
template class NeighbourList<double>;

}  // namespace warpgrain
