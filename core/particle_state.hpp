#pragma once
// The particles of a scene: what moves, and what forces depend on.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/contact_history.hpp"
#include "core/vector3.hpp"

namespace warpgrain {

// Structure of arrays, each [n_particles], SI units. Entry k of every array belongs to the particle with the
// permanent id `id[k]`; ids are unique and below 2^31. Back ends return states sorted by id.
struct ParticleState {
  std::vector<std::uint32_t> id;
  std::vector<std::uint32_t> material;     // index into Scene::materials
  std::vector<double> radius;              // m
  std::vector<double> mass;                // kg
  std::vector<Vector3d> position;          // m
  std::vector<Vector3d> velocity;          // m/s
  std::vector<Vector3d> angular_velocity;  // rad/s
  // The history as it stood BEFORE the force evaluation at this state: together with the arrays above it is
  // all that forces are a function of, so handing a state to another back end reproduces the same forces
  // there.
  ContactHistory contact_history;

  std::size_t size() const { return id.size(); }
};

// Forces [N] and torques [N m] on each particle, [n_particles], in the order of the state they were computed
// for; gravity included.
struct ForceState {
  std::vector<Vector3d> force;
  std::vector<Vector3d> torque;
};

}  // namespace warpgrain
