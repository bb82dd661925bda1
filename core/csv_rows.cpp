#include "core/csv_rows.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain {
namespace {

void split(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return;
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

CsvRows::CsvRows(std::string_view text, std::string_view file, std::span<const std::string_view> columns)
    : text_(text), file_(file), columns_(columns), place_(columns.size()) {
  std::string_view line;
  if (!next_line(line))
    throw_input_error(file_, "empty", fmt::format("a header line: {}", fmt::join(columns_, ",")));
  split(line, fields_);
  n_fields_ = fields_.size();
  for (std::size_t k = 0; k < n_fields_; ++k) {
    const auto found = std::find(columns_.begin(), columns_.end(), fields_[k]);
    if (found == columns_.end()) continue;
    auto& place = place_[static_cast<std::size_t>(found - columns_.begin())];
    if (place) fail(fmt::format("column '{}' twice", fields_[k]), "it once");
    place = k;
  }
}

void CsvRows::fail(std::string_view what, std::string_view expected) const {
  throw_input_error(fmt::format("{}: line {}", file_, line_number_), what, expected);
}

void CsvRows::require(std::size_t column) const {
  if (!has(column))
    fail(fmt::format("no column '{}'", columns_[column]),
         fmt::format("a header like {}", fmt::join(columns_, ",")));
}

bool CsvRows::next_line(std::string_view& line) {
  if (text_.empty()) return false;
  ++line_number_;
  const std::size_t end = text_.find('\n');
  if (end == std::string_view::npos) fail("the file ends within the line", "a line end behind the last row");
  line = text_.substr(0, end);
  text_.remove_prefix(end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return true;
}

bool CsvRows::next() {
  std::string_view line;
  if (!next_line(line)) return false;
  split(line, fields_);
  if (fields_.size() != n_fields_)
    fail(fmt::format("{} fields", fields_.size()), fmt::format("{} as in the header", n_fields_));
  return true;
}

double CsvRows::number(std::size_t column) const {
  if (!has(column)) return 0;
  const std::string_view text = fields_[*place_[column]];
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    fail(fmt::format("column '{}': '{}'", columns_[column], text), "a finite number");
  return value;
}

std::uint32_t CsvRows::whole_number(std::size_t column, std::uint64_t limit) const {
  const std::string_view text = fields_[*place_[column]];
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value >= limit)
    fail(fmt::format("column '{}': '{}'", columns_[column], text),
         limit == (std::uint64_t{1} << 31) ? "a whole number below 2^31"
                                           : fmt::format("a whole number below {}", limit));
  return value;
}

}  // namespace warpgrain
