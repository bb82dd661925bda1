#pragma once
// Particles and contacts for ParaView and everything else that reads VTK's XML formats: raw binary, little
// endian, 32-bit floats, which is what a picture needs and half the size. Files appear whole or not at all;
// InputError names one that cannot be written.

#include <filesystem>

#include "core/particle_state.hpp"
#include "core/scene.hpp"

namespace warpgrain::reports {

// Writes the particles as VTK PolyData (.vtp): a vertex a particle, with the point arrays id, radius,
// velocity and angular_velocity.
void write_vtk_particles(const std::filesystem::path& path, const ParticleState& state);

// Writes the contacts as VTK PolyData (.vtp): a line each, from a particle's centre to its partner's or to
// the nearest point of the wall, with the cell arrays particle (its id), partner (its id, or wall_partner_bit
// and the wall's index), overlap [m] and tangential_displacement [m, seen from the particle; zero where the
// variant keeps none]. `state` is of the scene's particles, inside its domain.
void write_vtk_contacts(const std::filesystem::path& path, const Scene& scene, const ParticleState& state);

}  // namespace warpgrain::reports
