#include "cli/checkpoint.hpp"

#include <cmath>
#include <fmt/format.h>
#include <string>
#include <unordered_map>

#include "core/contact_file.hpp"
#include "core/error.hpp"
#include "core/file_io.hpp"
#include "core/state_file.hpp"

namespace warpgrain::cli {
namespace {

constexpr const char* run_name = "run.json";
constexpr const char* state_name = "state.csv";
constexpr const char* contacts_name = "contacts.csv";

}  // namespace

void write_particles(const std::filesystem::path& folder, const ParticleState& state) {
  write_state_file(folder / state_name, state);
  write_contact_file(folder / contacts_name, state.contact_history);
}

// The document last: with it there is a checkpoint.
void write_checkpoint(const std::filesystem::path& folder, const reports::RunReport& report,
                      const ParticleState& state) {
  write_particles(folder, state);
  write_file_atomically(folder / run_name, reports::run_json(report));
}

reports::RunReport read_checkpoint(const std::filesystem::path& folder, const reports::RunReport& begun,
                                   Scene& scene) {
  reports::RunReport earlier = reports::read_run(folder / run_name);
  const auto expect = [&](std::string_view what, const auto& there, const auto& here) {
    if (there != here)
      throw_input_error((folder / run_name).string(), fmt::format("a run with {} {}", what, there),
                        fmt::format("{}, as this call says", here));
  };
  expect("scene", earlier.scene, begun.scene);
  expect("variant", earlier.variant, begun.variant);
  expect("back end", earlier.backend, begun.backend);
  expect("time step", earlier.time_step, begun.time_step);
  expect("particles", earlier.particles, begun.particles);
  read_particles(folder, scene);
  return earlier;
}

void read_particles(const std::filesystem::path& folder, Scene& scene) {
  const std::string where = (folder / state_name).string();
  const ParticleState state = read_state_file(folder / state_name);
  if (state.size() != scene.particles.size())
    throw_input_error(where, fmt::format("{} particles", state.size()),
                      fmt::format("{}", scene.particles.size()));
  std::unordered_map<std::uint32_t, std::size_t> place;
  for (std::size_t k = 0; k < scene.particles.size(); ++k) place.emplace(scene.particles.id[k], k);
  for (std::size_t k = 0; k < state.size(); ++k) {
    const auto found = place.find(state.id[k]);
    if (found == place.end() ||
        std::abs(scene.particles.radius[found->second] - state.radius[k]) > 1e-6 * state.radius[k])
      throw_input_error(where, fmt::format("particle {} of radius {}", state.id[k], state.radius[k]),
                        "the particles of the scene");
    scene.particles.position[found->second] = state.position[k];
    scene.particles.velocity[found->second] = state.velocity[k];
    scene.particles.angular_velocity[found->second] = state.angular_velocity[k];
  }
  scene.particles.contact_history = read_contact_file(folder / contacts_name);
  for (const ContactRecord& record : scene.particles.contact_history)
    for (const std::uint32_t partner : {record.particle_id, record.partner_id})
      if (partner & wall_partner_bit ? (partner & ~wall_partner_bit) >= scene.walls.size()
                                     : !place.contains(partner))
        throw_input_error((folder / contacts_name).string(),
                          fmt::format("a contact of {} and {}", record.particle_id, record.partner_id),
                          "particles and walls of the scene");
}

}  // namespace warpgrain::cli
