#pragma once
// The energies of a state [J].

#include "core/particle_state.hpp"
#include "core/scene.hpp"

namespace warpgrain {

struct Energy {
  double kinetic_translational = 0;  // sum of m v^2 / 2
  double kinetic_rotational = 0;     // sum of I w^2 / 2, I = 2/5 m r^2
  double gravitational = 0;          // - sum of m g.x, zero at the origin
  // Sum over the contacts of the work of F_n's spring: 2/5 C_kn sqrt(R*) overlap^2.5, the integral of eqs.
  // (4), (8); under the simple model k_spring overlap^2 / 2.
  double elastic_normal = 0;
  // Sum over the contacts of k_t delta_t^2 / 2, eqs. (4), (9), with the history that the state carries.
  double elastic_tangential = 0;

  double total() const {
    return kinetic_translational + kinetic_rotational + gravitational + elastic_normal + elastic_tangential;
  }
};

// The contact whose overlap is the largest part of a radius: the smaller one of two particles, the particle's
// at a wall.
struct DeepestContact {
  double share = 0;                               // overlap / that radius; 0 where nothing touches
  std::uint32_t particle_id = 0, partner_id = 0;  // a wall as contact_history.hpp has it
};

// Positions have to be finite and inside the domain. `deepest` is filled in where it is asked for.
Energy energy_of(const Scene& scene, const ParticleState& state, DeepestContact* deepest = nullptr);

}  // namespace warpgrain
