#pragma once
// How far the forces of a back end lie from those of the double reference, for the same state.

#include <cstdint>

#include "core/particle_state.hpp"

namespace warpgrain {

// Lengths of the difference vectors over all particles, divided by the length of the LARGEST reference vector
// of the scene. A particle at rest in a bed carries large contact forces that cancel to nearly its weight; a
// division by its own sum would measure that cancellation, not the arithmetic. One unit in the last place of
// a float is 1.2e-7 of the scale.
struct VectorError {
  double scale = 0;                  // length of the largest reference vector [N or N m]
  double maximum = 0;                // largest difference / scale
  double root_mean_square = 0;       // rms difference over the particles / scale
  std::uint32_t worst_particle = 0;  // permanent id of the particle with the largest difference
};

struct ForceError {
  VectorError force, torque;
};

// `state` gives the ids; `measured` and `reference` are in its order, [n_particles]. All zero against all
// zero has the error 0. Throws InputError when sizes differ, when a component of either is not finite (naming
// the particle), or when the reference is zero everywhere and the measured is not.
ForceError force_error(const ParticleState& state, const ForceState& measured, const ForceState& reference);

}  // namespace warpgrain
