#pragma once
// A handful of contacts, and a range of particles, as force terms see them. Structures of arrays, so that a
// term is a few array expressions and costs one virtual call a batch, none a pair. SI units; n is the unit
// vector from particle i to its partner j, and every force is the force on i (j gets its exact negative).

#include <Eigen/Core>
#include <span>

#include "core/vector3.hpp"

namespace warpgrain {

template <class Real>
struct ContactBatch {
  static constexpr int capacity = 64;  // about 18 KiB in double: stays in a first-level cache
  using Scalars = Eigen::Array<Real, capacity, 1>;
  using Vectors = Eigen::Array<Real, capacity, 3>;  // a row a contact, columns x, y, z

  // Contacts in use. Expressions may run over all `capacity` rows: the others hold harmless numbers, never
  // read.
  int size = 0;

  // What is known of each contact.
  Scalars overlap = Scalars::Zero();                     // delta_n > 0
  Scalars effective_radius = Scalars::Zero();            // R*
  Scalars effective_mass = Scalars::Zero();              // m*
  Vectors contact_normal = Vectors::Zero();              // n
  Vectors relative_velocity = Vectors::Zero();           // v = v_i - v_j
  Vectors surface_spin = Vectors::Zero();                // r_i w_i + r_j w_j
  Scalars normal_velocity = Scalars::Zero();             // v.n
  Vectors centre_tangential_velocity = Vectors::Zero();  // v - (v.n) n, without the spins
  Vectors tangential_velocity = Vectors::Zero();         // v_t of eq. (6)
  Scalars normal_parameter = Scalars::Zero();            // C_kn
  Scalars tangential_parameter = Scalars::Zero();        // C_kt
  Scalars damping_parameter = Scalars::Zero();           // alpha
  Scalars friction_coefficient = Scalars::Zero();        // mu

  // Set by a term of stage `coefficients`; zero without one.
  Scalars normal_stiffness = Scalars::Zero();      // k_n
  Scalars tangential_stiffness = Scalars::Zero();  // k_t
  Scalars damping_coefficient = Scalars::Zero();   // eta

  // delta_t: on entry as the last evaluation left it, updated by the terms that keep a history.
  Vectors tangential_displacement = Vectors::Zero();

  // What terms add to.
  Scalars normal_force = Scalars::Zero();      // along n: negative pushes i away from j
  Vectors tangential_force = Vectors::Zero();  // at the contact point: turns both bodies, eq. (3)
  Vectors central_force = Vectors::Zero();     // through the centres: turns neither
};

// Row by row products. Written out, because Eigen's own reductions may add the columns in another order in
// the rows left over by vector instructions, and bits must not depend on a contact's place in its batch.
template <class A, class B>
auto row_dot(const A& a, const B& b) {
  return a.col(0) * b.col(0) + a.col(1) * b.col(1) + a.col(2) * b.col(2);
}

// A range of particles, for forces on single bodies. All [size].
template <class Real>
struct BodyBatch {
  std::span<const Real> mass, radius;
  std::span<const Vector3<Real>> position, velocity, angular_velocity;
  std::span<Vector3<Real>> force, torque;  // to be added to
};

}  // namespace warpgrain
