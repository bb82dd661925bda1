#include "core/state_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <unordered_set>
#include <vector>

#include "core/error.hpp"
#include "core/file_io.hpp"

namespace warpgrain {
namespace {

constexpr std::array<std::string_view, 11> columns{"id", "x",  "y",  "z",  "vx",    "vy",
                                                   "vz", "wx", "wy", "wz", "radius"};
enum Column : std::size_t { id, x, y, z, vx, vy, vz, wx, wy, wz, radius_column };

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

class Reader {
 public:
  Reader(std::string_view text, std::string_view file) : text_(text), file_(file) {}

  ParticleState read(std::optional<double> radius) {
    std::string_view line;
    if (!next_line(line)) throw_input_error(file_, "empty", "a header line: " + std::string(header()));
    read_header(line, radius.has_value());
    ParticleState state;
    std::unordered_set<std::uint32_t> ids;
    while (next_line(line)) {
      fields_ = split(line);
      if (fields_.size() != n_fields_)
        fail(fmt::format("{} fields", fields_.size()), fmt::format("{} as in the header", n_fields_));
      state.id.push_back(particle_id());
      if (!ids.insert(state.id.back()).second)
        fail(fmt::format("id {} twice", state.id.back()), "unique ids");
      state.position.emplace_back(number(x), number(y), number(z));
      state.velocity.emplace_back(number(vx), number(vy), number(vz));
      state.angular_velocity.emplace_back(number(wx), number(wy), number(wz));
      state.radius.push_back(place_[radius_column] ? number(radius_column) : *radius);
      if (!(state.radius.back() > 0)) fail(fmt::format("radius {}", state.radius.back()), "a radius above 0");
    }
    state.material.assign(state.size(), 0);
    state.mass.assign(state.size(), 0);
    return state;
  }

 private:
  static std::string header() { return fmt::format("{}", fmt::join(columns, ",")); }
  [[noreturn]] void fail(std::string_view what, std::string_view expected) const {
    throw_input_error(fmt::format("{}: line {}", file_, line_number_), what, expected);
  }

  // A last line without its end is taken for a file cut in the middle: "0.00" may have been "0.0021".
  bool next_line(std::string_view& line) {
    if (text_.empty()) return false;
    ++line_number_;
    const std::size_t end = text_.find('\n');
    if (end == std::string_view::npos)
      fail("the file ends within the line", "a line end behind the last row");
    line = text_.substr(0, end);
    text_.remove_prefix(end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return true;
  }

  void read_header(std::string_view line, bool has_radius) {
    const auto names = split(line);
    n_fields_ = names.size();
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto found = std::find(columns.begin(), columns.end(), names[k]);
      if (found == columns.end()) continue;
      auto& place = place_[static_cast<std::size_t>(found - columns.begin())];
      if (place) fail(fmt::format("column '{}' twice", names[k]), "it once");
      place = k;
    }
    for (std::size_t column : {id, x, y, z})
      if (!place_[column]) fail(fmt::format("no column '{}'", columns[column]), "a header like " + header());
    if (!place_[radius_column] && !has_radius)
      fail("no column 'radius'", "it, or one radius for all beside the file");
  }

  std::string_view field(std::size_t column) const { return fields_[*place_[column]]; }

  double number(std::size_t column) const {
    if (!place_[column]) return 0;
    const std::string_view text = field(column);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
      fail(fmt::format("column '{}': '{}'", columns[column], text), "a finite number");
    return value;
  }

  std::uint32_t particle_id() const {
    const std::string_view text = field(id);
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value >= wall_partner_bit)
      fail(fmt::format("column 'id': '{}'", text), "a whole number below 2^31");
    return value;
  }

  std::string_view text_, file_;
  std::size_t line_number_ = 0, n_fields_ = 0;
  std::array<std::optional<std::size_t>, columns.size()> place_;  // of each column among the fields
  std::vector<std::string_view> fields_;
};

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
  return Reader(text, where).read(radius);
}

ParticleState read_state_file(const std::filesystem::path& path, std::optional<double> radius) {
  return parse_state_csv(read_text_file(path, state_size_limit), path.string(), radius);
}

}  // namespace warpgrain
