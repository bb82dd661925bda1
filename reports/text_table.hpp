#pragma once
// Aligned columns for a terminal.

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
  // Headings, a rule, the rows; each line ends with a newline and has no blanks before it.
  std::string text() const;

 private:
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace warpgrain::reports
