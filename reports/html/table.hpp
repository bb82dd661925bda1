#pragma once
// Tables whose headings explain themselves and sort the rows when clicked.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/metrics.hpp"

namespace warpgrain::reports::html {

struct Cell {
  std::string html;
  std::optional<double> sort_by;  // none: the text
  std::optional<double> heat;     // 0 to 1: shade of the background
};

Cell text_cell(std::string_view text);     // escaped
Cell wrapped_cell(std::string_view text);  // the same, on several lines where it is long
Cell count_cell(std::uint64_t count);
Cell number_cell(double value, int decimals);
Cell share_cell(double part, double whole);                     // a percentage and a bar
Cell optional_cell(std::optional<double> value, int decimals);  // "-" for none

// What a number is, and what Nsight Compute calls it.
std::string explanation(const Metric& metric);
// The same in other words, where a table has the metric of something smaller than a launch.
std::string explanation(std::string_view words, std::string_view metric_key);

class Table {
 public:
  struct Column {
    std::string heading;
    std::string explanation;  // shown on hovering
    bool is_text = false;     // left-aligned
  };

  explicit Table(std::vector<Column> columns);
  void add_row(std::vector<Cell> cells);     // one a column
  void set_footer(std::vector<Cell> cells);  // one a column; stays below when sorting
  std::string html() const;

  static Column of_metric(std::string_view key);
  static std::string heading_html(const Column& column);

 private:
  std::string row_html(const std::vector<Cell>& cells) const;

  std::vector<Column> columns_;
  std::vector<std::vector<Cell>> rows_;
  std::vector<Cell> footer_;
};

}  // namespace warpgrain::reports::html
