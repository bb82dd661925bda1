#include "core/contact_forces.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"
#include "core/overlap.hpp"

namespace warpgrain {
namespace {

bool precedes(const ContactRecord& a, const ContactRecord& b) {
  return std::pair(a.particle_id, a.partner_id) < std::pair(b.particle_id, b.partner_id);
}

bool is_wall(std::uint32_t partner) { return (partner & wall_partner_bit) != 0; }

// v_n and v_t of eq. (6).
template <class Real>
void complete_velocities(ContactBatch<Real>& c) {
  c.normal_velocity = row_dot(c.relative_velocity, c.contact_normal);
  c.centre_tangential_velocity = c.relative_velocity - c.contact_normal.colwise() * c.normal_velocity;
  c.tangential_velocity = c.centre_tangential_velocity;
  for (int d = 0; d < 3; ++d) {
    const int e = (d + 1) % 3, f = (d + 2) % 3;
    c.tangential_velocity.col(d) +=
        c.surface_spin.col(e) * c.contact_normal.col(f) - c.surface_spin.col(f) * c.contact_normal.col(e);
  }
}

template <class Real>
void clear_forces(ContactBatch<Real>& c) {
  c.normal_stiffness.setZero();
  c.tangential_stiffness.setZero();
  c.damping_coefficient.setZero();
  c.normal_force.setZero();
  c.tangential_force.setZero();
  c.central_force.setZero();
}

// Applies the terms to the batch and writes its results behind `first`.
template <class Real>
void flush(ContactBatch<Real>& c, const ForceTermList<Real>& terms, Real time_step, Vector3<Real>* force,
           Vector3<Real>* turn, Vector3<Real>* displacement) {
  complete_velocities(c);
  clear_forces(c);
  terms.apply(c, time_step);
  for (int k = 0; k < c.size; ++k) {
    const Vector3<Real> normal = c.contact_normal.row(k), tangential = c.tangential_force.row(k);
    force[k] = normal * c.normal_force[k] + tangential + Vector3<Real>(c.central_force.row(k));
    turn[k] = normal.cross(tangential);
    displacement[k] = c.tangential_displacement.row(k);
  }
  c.size = 0;
}

}  // namespace

template <class Real>
ContactForces<Real>::ContactForces(const Scene& scene, const std::vector<IndexRange>& ranges,
                                   std::size_t contact_slots)
    : walls_(scene.walls),
      parameters_(scene.contacts),
      ranges_(ranges),
      contact_slots_(contact_slots),
      before_(ranges.size()),
      after_(ranges.size()),
      work_(ranges.size()) {
  for (std::size_t r = 0; r < ranges_.size(); ++r) {
    before_[r].rows.row_start.assign(ranges_[r].size() + 1, 0);
    after_[r].rows.row_start.assign(ranges_[r].size() + 1, 0);
  }
}

template <class Real>
void ContactForces<Real>::set_history(const ContactHistory& history, const ParticleArrays<Real>& particles) {
  const auto index_of = [&](std::uint32_t id) {
    const auto found = std::lower_bound(particles.id.begin(), particles.id.end(), id);
    if (found == particles.id.end() || *found != id)
      throw_input_error("contact history", fmt::format("particle {}", id),
                        "the id of a particle of the state");
    return static_cast<std::uint32_t>(found - particles.id.begin());
  };
  if (!std::is_sorted(history.begin(), history.end(), precedes))
    throw_input_error("contact history", "out of order", "records sorted by particle and partner");
  // Kept are the records seen from the particle of the lower id: indices ascend with ids, so rows come out
  // sorted.
  auto record = history.begin();
  for (std::size_t r = 0; r < ranges_.size(); ++r) {
    // "After" the evaluation that never was; the first one makes it "before".
    TouchingRows& touching = after_[r];
    for (std::size_t i = ranges_[r].first; i < ranges_[r].last; ++i) {
      for (; record != history.end() && record->particle_id <= particles.id[i]; ++record) {
        const bool wall = is_wall(record->partner_id);
        if (record->particle_id < particles.id[i]) index_of(record->particle_id);  // skipped over: refused
        if (!wall && record->partner_id <= record->particle_id) continue;
        touching.rows.partner.push_back(wall ? record->partner_id : index_of(record->partner_id));
        touching.tangential_displacement.push_back(record->tangential_displacement.template cast<Real>());
      }
      touching.rows.row_start[i - ranges_[r].first + 1] =
          static_cast<std::uint32_t>(touching.rows.partner.size());
    }
  }
  if (record != history.end()) index_of(record->particle_id);  // above all ids there are: refused
}

template <class Real>
void ContactForces<Real>::evaluate(const ForceTermList<Real>& terms, const NeighbourList<Real>& candidates,
                                   Real time_step, ParticleArrays<Real>& particles) {
  keeps_history_ = terms.keeps_history();
  std::swap(before_, after_);
  for_each_range(ranges_.size(),
                 [&](std::size_t range) { evaluate_range(range, terms, candidates, time_step, particles); });
  add_up(particles);
  for_each_range(ranges_.size(),
                 [&](std::size_t range) { add_body_forces(ranges_[range], terms, particles); });
}

template <class Real>
void ContactForces<Real>::evaluate_range(std::size_t range, const ForceTermList<Real>& terms,
                                         const NeighbourList<Real>& candidates, Real time_step,
                                         const ParticleArrays<Real>& particles) {
  const PartnerRows& candidate = candidates.rows(range);
  const TouchingRows& before = before_[range];
  TouchingRows& after = after_[range];
  Workspace& work = work_[range];
  // Room for all candidates, so that nothing is allocated in the loop; row_start says how much of it is used.
  const std::size_t room = candidate.partner.size();
  after.rows.partner.resize(room);
  after.tangential_displacement.resize(room);
  work.force.resize(room);
  work.turn.resize(room);

  ContactBatch<Real>& batch = work.batch;
  batch.size = 0;
  std::uint32_t n_touching = 0, n_done = 0;
  const auto finish_batch = [&] {
    flush(batch, terms, time_step, &work.force[n_done], &work.turn[n_done],
          &after.tangential_displacement[n_done]);
    n_done = n_touching;
  };
  for (std::size_t row = 0; row < ranges_[range].size(); ++row) {
    std::uint32_t old = before.rows.row_start[row];
    for (std::uint32_t k = candidate.row_start[row]; k < candidate.row_start[row + 1]; ++k) {
      const std::uint32_t partner = candidate.partner[k];
      if (!gather_if_touching(ranges_[range].first + row, partner, particles, batch)) continue;
      // Both rows ascend.
      while (old < before.rows.row_start[row + 1] && before.rows.partner[old] < partner) ++old;
      const bool known =
          keeps_history_ && old < before.rows.row_start[row + 1] && before.rows.partner[old] == partner;
      if (known)
        batch.tangential_displacement.row(batch.size - 1) = before.tangential_displacement[old];
      else
        batch.tangential_displacement.row(batch.size - 1).setZero();
      after.rows.partner[n_touching++] = partner;
      if (batch.size == ContactBatch<Real>::capacity) finish_batch();
    }
    after.rows.row_start[row + 1] = n_touching;
  }
  if (batch.size > 0) finish_batch();
}

template <class Real>
bool ContactForces<Real>::gather_if_touching(std::size_t i, std::uint32_t partner,
                                             const ParticleArrays<Real>& p, ContactBatch<Real>& batch) const {
  const int k = batch.size;
  const Real radius = p.radius[i];
  std::uint32_t partner_material;
  if (is_wall(partner)) {
    const Wall& wall = walls_[partner & ~wall_partner_bit];
    const WallProximity near = wall_proximity(wall, p.position[i].template cast<double>());
    const auto overlap = static_cast<Real>(radius - near.distance);
    if (!(overlap > 0)) return false;
    batch.overlap[k] = overlap;
    batch.contact_normal.row(k) = near.contact_normal.template cast<Real>();
    batch.effective_radius[k] = radius;
    batch.effective_mass[k] = p.mass[i];
    batch.relative_velocity.row(k) = p.velocity[i];
    batch.surface_spin.row(k) = radius * p.angular_velocity[i];
    partner_material = wall.material;
  } else {
    const std::uint32_t j = partner;
    const Vector3<Real> apart = p.position[j] - p.position[i];
    const Real reach = radius + p.radius[j], squared_distance = apart.squaredNorm();
    if (!(squared_distance < reach * reach)) return false;
    const Real distance = std::sqrt(squared_distance);
    if (!(distance > 0))
      throw_simulation_error(fmt::format("particle {}", p.id[i]),
                             fmt::format("its centre lies on that of particle {}", p.id[j]),
                             "a direction between the two");
    // Rounding may leave nothing of an overlap in the last place.
    const Real overlap = overlap_of_spheres(apart, distance, reach);
    if (!(overlap > 0)) return false;
    batch.overlap[k] = overlap;
    batch.contact_normal.row(k) = apart / distance;
    batch.effective_radius[k] = radius * p.radius[j] / reach;
    batch.effective_mass[k] = p.mass[i] * p.mass[j] / (p.mass[i] + p.mass[j]);
    batch.relative_velocity.row(k) = p.velocity[i] - p.velocity[j];
    batch.surface_spin.row(k) = radius * p.angular_velocity[i] + p.radius[j] * p.angular_velocity[j];
    partner_material = p.material[j];
  }
  const ContactParameters& parameters = parameters_.at(p.material[i], partner_material);
  batch.normal_parameter[k] = static_cast<Real>(parameters.normal_parameter);
  batch.tangential_parameter[k] = static_cast<Real>(parameters.tangential_parameter);
  batch.damping_parameter[k] = static_cast<Real>(parameters.damping_parameter);
  batch.friction_coefficient[k] = static_cast<Real>(parameters.friction_coefficient);
  ++batch.size;
  return true;
}

template <class Real>
void ContactForces<Real>::add_up(ParticleArrays<Real>& p) {
  p.force.assign(p.id.size(), Vector3<Real>::Zero());
  p.torque.assign(p.id.size(), Vector3<Real>::Zero());
  contacts_of_.assign(p.id.size(), 0);
  for (std::size_t r = 0; r < ranges_.size(); ++r) {
    const PartnerRows& rows = after_[r].rows;
    for (std::size_t i = ranges_[r].first; i < ranges_[r].last; ++i) {
      const std::size_t row = i - ranges_[r].first;
      for (std::uint32_t k = rows.row_start[row]; k < rows.row_start[row + 1]; ++k) {
        p.force[i] += work_[r].force[k];
        p.torque[i] += p.radius[i] * work_[r].turn[k];
        ++contacts_of_[i];
        const std::uint32_t j = rows.partner[k];
        if (is_wall(j)) continue;
        // n and F_t both change their sign, seen from j: their product does not.
        p.force[j] -= work_[r].force[k];
        p.torque[j] += p.radius[j] * work_[r].turn[k];
        ++contacts_of_[j];
      }
    }
  }
  for (std::size_t i = 0; i < p.id.size(); ++i)
    if (contacts_of_[i] > contact_slots_)
      throw_simulation_error(fmt::format("particle {}", p.id[i]),
                             fmt::format("{} contacts at once", contacts_of_[i]),
                             fmt::format("at most {} (contact slots)", contact_slots_));
}

template <class Real>
void ContactForces<Real>::add_body_forces(const IndexRange& range, const ForceTermList<Real>& terms,
                                          ParticleArrays<Real>& p) {
  const auto part = [&](auto& array) { return std::span(array).subspan(range.first, range.size()); };
  BodyBatch<Real> bodies{part(p.mass),     part(p.radius),           part(p.position),
                         part(p.velocity), part(p.angular_velocity), part(p.force),
                         part(p.torque)};
  terms.apply(bodies);
  for (std::size_t i = range.first; i < range.last; ++i)
    if (!p.force[i].allFinite() || !p.torque[i].allFinite())
      throw_simulation_error(
          fmt::format("particle {}", p.id[i]),
          fmt::format("force ({}, {}, {})", p.force[i].x(), p.force[i].y(), p.force[i].z()),
          "finite numbers");
}

template <class Real>
std::uint64_t ContactForces<Real>::contact_count() const {
  std::uint64_t total = 0;
  for (const TouchingRows& touching : after_) total += touching.rows.row_start.back();
  return total;
}

template <class Real>
ContactHistory ContactForces<Real>::listed(const std::vector<TouchingRows>& touching,
                                           const ParticleArrays<Real>& particles) const {
  ContactHistory history;
  if (!keeps_history_) return history;
  for (std::size_t r = 0; r < ranges_.size(); ++r) {
    const PartnerRows& rows = touching[r].rows;
    for (std::size_t row = 0; row < ranges_[r].size(); ++row)
      for (std::uint32_t k = rows.row_start[row]; k < rows.row_start[row + 1]; ++k) {
        const std::uint32_t id = particles.id[ranges_[r].first + row], j = rows.partner[k];
        const Vector3d displacement = touching[r].tangential_displacement[k].template cast<double>();
        history.push_back({id, is_wall(j) ? j : particles.id[j], displacement});
        if (!is_wall(j)) history.push_back({particles.id[j], id, -displacement});
      }
  }
  std::sort(history.begin(), history.end(), precedes);
  return history;
}

template class ContactForces<float>;
template class ContactForces<double>;

}  // namespace warpgrain
