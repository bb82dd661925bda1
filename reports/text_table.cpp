#include "reports/text_table.hpp"

#include <algorithm>
#include <utility>

#include "core/error.hpp"

namespace warpgrain::reports {
namespace {

// Code points, which is what a terminal's columns hold for the letters that occur here.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

TextTable::TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {}

void TextTable::add_row(std::vector<std::string> cells) {
  if (cells.size() != columns_.size())
    throw_input_error("table row", std::to_string(cells.size()) + " cells", std::to_string(columns_.size()));
  rows_.push_back(std::move(cells));
}

std::string TextTable::text() const {
  std::vector<std::size_t> widths;
  std::vector<std::string> headings, rules;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    headings.push_back(columns_[c].heading);
    widths.push_back(width_of(headings.back()));
    for (const auto& row : rows_) widths.back() = std::max(widths.back(), width_of(row[c]));
    rules.emplace_back(widths.back(), '-');
  }
  std::string text;
  const auto append = [&](const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const std::string blanks(widths[c] - width_of(cells[c]), ' ');
      if (c > 0) line += "  ";
      line += columns_[c].align == Align::left ? cells[c] + blanks : blanks + cells[c];
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  };
  append(headings);
  append(rules);
  for (const auto& row : rows_) append(row);
  return text;
}

}  // namespace warpgrain::reports
