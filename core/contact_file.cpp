#include "core/contact_file.hpp"

#include <array>
#include <fmt/format.h>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "core/csv_rows.hpp"
#include "core/file_io.hpp"
#include "core/state_file.hpp"

namespace warpgrain {
namespace {

constexpr std::array<std::string_view, 5> contact_columns{"particle_id", "partner_id", "x", "y", "z"};
enum ContactColumn : std::size_t { particle_column, partner_column, x_column, y_column, z_column };

}  // namespace

void write_contact_file(const std::filesystem::path& path, const ContactHistory& history) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}\n", fmt::join(contact_columns, ","));
  for (const ContactRecord& record : history) {
    const Vector3d& displacement = record.tangential_displacement;
    fmt::format_to(out, "{},{},{},{},{}\n", record.particle_id, record.partner_id, displacement.x(),
                   displacement.y(), displacement.z());
  }
  write_file_atomically(path, fmt::to_string(text));
}

ContactHistory read_contact_file(const std::filesystem::path& path) {
  const std::string text = read_text_file(path, state_size_limit), name = path.string();
  CsvRows rows(text, name, contact_columns);
  for (std::size_t column = 0; column < contact_columns.size(); ++column) rows.require(column);
  ContactHistory history;
  while (rows.next()) {
    ContactRecord record;
    record.particle_id = rows.whole_number(particle_column, wall_partner_bit);
    record.partner_id = rows.whole_number(partner_column, std::uint64_t{1} << 32);
    record.tangential_displacement = {rows.number(x_column), rows.number(y_column), rows.number(z_column)};
    if (!history.empty() && std::pair(history.back().particle_id, history.back().partner_id) >=
                                std::pair(record.particle_id, record.partner_id))
      rows.fail(fmt::format("contact of {} and {} behind that of {} and {}", record.particle_id,
                            record.partner_id, history.back().particle_id, history.back().partner_id),
                "rows sorted by particle_id and partner_id, each pair once");
    history.push_back(record);
  }
  return history;
}

}  // namespace warpgrain
