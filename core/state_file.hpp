#pragma once
// States as CSV: a header line, then a row a particle, SI units:
//   id,x,y,z,vx,vy,vz,wx,wy,wz,radius
// Numbers are printed so that reading them back gives the same doubles. On reading the columns may stand in
// any order, others are ignored, missing velocities are zero. Contact histories are not part of the format.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/particle_state.hpp"

namespace warpgrain {

inline constexpr std::uintmax_t state_size_limit = std::uintmax_t{4} << 30;  // bytes

std::string format_state_csv(const ParticleState& state);
// Atomic: the file is whole or not there. Throws InputError when it cannot be written.
void write_state_file(const std::filesystem::path& path, const ParticleState& state);

// Fills id, position, velocities and radius [n_particles]; material and mass are left zero, for the caller to
// set. `radius` [m] is for files without a radius column. Throws InputError naming file and line: a row with
// too few or too many fields, a field that is no finite number, a radius not above zero, an id twice, a last
// line without its end.
ParticleState parse_state_csv(std::string_view text, std::string_view where,
                              std::optional<double> radius = {});
ParticleState read_state_file(const std::filesystem::path& path, std::optional<double> radius = {});

}  // namespace warpgrain
