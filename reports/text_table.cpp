#include "reports/text_table.hpp"

#include <algorithm>
#include <sstream>
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
  const std::vector<std::vector<std::string>> headings = heading_lines();
  std::vector<std::size_t> widths(columns_.size(), 0);
  for (const auto* rows : {&headings, &rows_})
    for (const auto& row : *rows)
      for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width_of(row[c]));
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
  for (const auto& row : headings) append(row);
  std::vector<std::string> rule;
  for (const std::size_t width : widths) rule.emplace_back(width, '-');
  append(rule);
  for (const auto& row : rows_) append(row);
  return text;
}

std::vector<std::vector<std::string>> TextTable::heading_lines() const {
  std::vector<std::vector<std::string>> words(columns_.size());
  std::size_t most = 0;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    std::istringstream heading(columns_[c].heading);
    for (std::string word; heading >> word;) words[c].push_back(word);
    most = std::max(most, words[c].size());
  }
  std::vector<std::vector<std::string>> lines(most, std::vector<std::string>(columns_.size()));
  for (std::size_t c = 0; c < columns_.size(); ++c)
    for (std::size_t w = 0; w < words[c].size(); ++w) lines[most - words[c].size() + w][c] = words[c][w];
  return lines;
}

}  // namespace warpgrain::reports
