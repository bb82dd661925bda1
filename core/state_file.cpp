#include "core/state_file.hpp"

#include <array>
#include <fmt/format.h>
#include <unordered_set>

#include "core/csv_rows.hpp"
#include "core/file_io.hpp"

namespace warpgrain {
namespace {

constexpr std::array<std::string_view, 11> columns{"id", "x",  "y",  "z",  "vx",    "vy",
                                                   "vz", "wx", "wy", "wz", "radius"};
enum Column : std::size_t { id, x, y, z, vx, vy, vz, wx, wy, wz, radius_column };

}  // namespace

std::string format_state_csv(const ParticleState& state) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}\n", fmt::join(columns, ","));
  for (std::size_t k = 0; k < state.size(); ++k) {
    const Vector3d &p = state.position[k], &v = state.velocity[k], &w = state.angular_velocity[k];
    // {} prints the shortest text that reads back as the same double.
    fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{},{}\n", state.id[k], p.x(), p.y(), p.z(), v.x(), v.y(),
                   v.z(), w.x(), w.y(), w.z(), state.radius[k]);
  }
  return fmt::to_string(text);
}

void write_state_file(const std::filesystem::path& path, const ParticleState& state) {
  write_file_atomically(path, format_state_csv(state));
}

ParticleState parse_state_csv(std::string_view text, std::string_view where, std::optional<double> radius) {
  CsvRows rows(text, where, columns);
  for (std::size_t column : {id, x, y, z}) rows.require(column);
  if (!rows.has(radius_column) && !radius)
    rows.fail("no column 'radius'", "it, or one radius for all beside the file");
  ParticleState state;
  std::unordered_set<std::uint32_t> ids;
  while (rows.next()) {
    state.id.push_back(rows.whole_number(id, wall_partner_bit));
    if (!ids.insert(state.id.back()).second)
      rows.fail(fmt::format("id {} twice", state.id.back()), "unique ids");
    state.position.emplace_back(rows.number(x), rows.number(y), rows.number(z));
    state.velocity.emplace_back(rows.number(vx), rows.number(vy), rows.number(vz));
    state.angular_velocity.emplace_back(rows.number(wx), rows.number(wy), rows.number(wz));
    state.radius.push_back(rows.has(radius_column) ? rows.number(radius_column) : *radius);
    if (!(state.radius.back() > 0))
      rows.fail(fmt::format("radius {}", state.radius.back()), "a radius above 0");
  }
  state.material.assign(state.size(), 0);
  state.mass.assign(state.size(), 0);
  return state;
}

ParticleState read_state_file(const std::filesystem::path& path, std::optional<double> radius) {
  return parse_state_csv(read_text_file(path, state_size_limit), path.string(), radius);
}

}  // namespace warpgrain
