#pragma once
// What a contact remembers between steps, in the form in which states are exchanged between back ends. Each
// back end stores it as it likes (slots a particle on a GPU); this form is independent of any order of the
// particles.

#include <cstdint>
#include <vector>

#include "core/vector3.hpp"

namespace warpgrain {

// Partner ids of walls: the wall's index in the scene with this bit set. Particle ids are below it.
inline constexpr std::uint32_t wall_partner_bit = 0x80000000u;

// The tangential displacement delta_t [m] (eq. 7) of particle `particle_id` in its contact with `partner_id`,
// seen from the particle; seen from the partner it is the negative. Both directions of a pair of particles
// are listed.
struct ContactRecord {
  std::uint32_t particle_id = 0;
  std::uint32_t partner_id = 0;
  Vector3d tangential_displacement = Vector3d::Zero();
};

// Sorted by (particle_id, partner_id), each pair of ids once.
using ContactHistory = std::vector<ContactRecord>;

// Gives each pair of particles one displacement: the one of the smaller id, and its negative to the other. A
// device keeps both sides apart and rounds them apart, the reference keeps one: without this, comparing the
// two from a device's state measures how far its sides have parted.
void make_antisymmetric(ContactHistory& history);

}  // namespace warpgrain
