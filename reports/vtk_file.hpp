#pragma once
// Particles for ParaView and everything else that reads VTK's XML formats.

#include <filesystem>

#include "core/particle_state.hpp"

namespace warpgrain::reports {

// Writes the particles as VTK PolyData (.vtp): a vertex a particle, with the point arrays id, radius,
// velocity and angular_velocity; raw binary, little endian, 32-bit floats, which is what a picture needs and
// half the size. The file appears whole or not at all; throws InputError naming it otherwise.
void write_vtk_particles(const std::filesystem::path& path, const ParticleState& state);

}  // namespace warpgrain::reports
