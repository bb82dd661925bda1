#pragma once
// Aligned columns for a terminal. Headings of several words stand on several lines, to keep columns narrow.

#include <string>
#include <vector>

namespace warpgrain::reports {

class TextTable {
 public:
  enum class Align { left, right };
  struct Column {
    std::string heading;
    Align align = Align::right;
  };

  explicit TextTable(std::vector<Column> columns);
  void add_row(std::vector<std::string> cells);  // one a column
  // Headings, ending on one line; a rule; the rows. Each line ends with a newline and has no blanks before
  // it.
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> heading_lines() const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace warpgrain::reports
