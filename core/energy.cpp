#include "core/energy.hpp"

#include <algorithm>
#include <cmath>

#include "core/neighbour_list.hpp"

namespace warpgrain {
namespace {

struct Contact {
  double overlap, effective_radius, smaller_radius;
  std::uint32_t partner_id, partner_material;
};

Contact contact_of(const Scene& scene, const ParticleState& state, std::size_t i, std::uint32_t partner) {
  if (partner & wall_partner_bit) {
    const Wall& wall = scene.walls[partner & ~wall_partner_bit];
    const double overlap = state.radius[i] - wall_proximity(wall, state.position[i]).distance;
    return {overlap, state.radius[i], state.radius[i], partner, wall.material};
  }
  const double reach = state.radius[i] + state.radius[partner];
  // Touching is decided on squares; rounding may leave less than nothing of the overlap.
  const double overlap = std::max(0.0, reach - (state.position[partner] - state.position[i]).norm());
  return {overlap, state.radius[i] * state.radius[partner] / reach,
          std::min(state.radius[i], state.radius[partner]), state.id[partner], state.material[partner]};
}

double squared_displacement(const ContactHistory& history, std::uint32_t particle, std::uint32_t partner) {
  const auto before = [](const ContactRecord& record, const std::pair<std::uint32_t, std::uint32_t>& key) {
    return std::pair(record.particle_id, record.partner_id) < key;
  };
  const auto found = std::lower_bound(history.begin(), history.end(), std::pair(particle, partner), before);
  if (found == history.end() || found->particle_id != particle || found->partner_id != partner) return 0;
  return found->tangential_displacement.squaredNorm();
}

}  // namespace

Energy energy_of(const Scene& scene, const ParticleState& state, DeepestContact* deepest) {
  Energy energy;
  for (std::size_t k = 0; k < state.size(); ++k) {
    const double inertia = 0.4 * state.mass[k] * state.radius[k] * state.radius[k];
    energy.kinetic_translational += state.mass[k] * state.velocity[k].squaredNorm() / 2;
    energy.kinetic_rotational += inertia * state.angular_velocity[k].squaredNorm() / 2;
    energy.gravitational -= state.mass[k] * scene.gravity.dot(state.position[k]);
  }

  NeighbourList<double> touching(scene.domain, scene.walls, state.radius, 0, split_ranges(state.size(), 1));
  touching.build(state.position);
  const PartnerRows& rows = touching.rows(0);
  for (std::size_t i = 0; i < state.size(); ++i)
    for (std::uint32_t k = rows.row_start[i]; k < rows.row_start[i + 1]; ++k) {
      const Contact contact = contact_of(scene, state, i, rows.partner[k]);
      const double share = contact.overlap / contact.smaller_radius;
      if (deepest && share > deepest->share) *deepest = {share, state.id[i], contact.partner_id};
      if (scene.model.contact == ContactModel::simple) {
        energy.elastic_normal += scene.model.simple.k_spring * contact.overlap * contact.overlap / 2;
        continue;
      }
      const ContactParameters& parameters = scene.contacts.at(state.material[i], contact.partner_material);
      const double contact_radius = std::sqrt(contact.overlap * contact.effective_radius);
      energy.elastic_normal +=
          0.4 * parameters.normal_parameter * contact_radius * contact.overlap * contact.overlap;
      energy.elastic_tangential +=
          parameters.tangential_parameter * contact_radius / 2 *
          squared_displacement(state.contact_history, state.id[i], contact.partner_id);
    }
  return energy;
}

}  // namespace warpgrain
