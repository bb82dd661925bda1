#pragma once
// Reads CSV tables of numbers: a header line that names the columns, in any order, then a row a line. What is
// wrong is named with file and line.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace warpgrain {

class CsvRows {
 public:
  // `text`, `file` (the name for messages) and `columns` must outlive the object. Columns of the header that
  // are not among `columns` are ignored. Throws InputError: no header, or a column twice.
  CsvRows(std::string_view text, std::string_view file, std::span<const std::string_view> columns);

  bool has(std::size_t column) const { return place_[column].has_value(); }
  // Throws InputError when the header has no such column.
  void require(std::size_t column) const;

  // The next row; false behind the last. Throws InputError: too few or too many fields, or a last line
  // without its end, which is taken for a file cut in the middle ("0.00" may have been "0.0021").
  bool next();

  // A field of the row; 0 where the file has no such column. Throws InputError unless it is a finite number.
  double number(std::size_t column) const;
  // Throws InputError unless it is a whole number below `limit`.
  std::uint32_t whole_number(std::size_t column, std::uint64_t limit) const;

  // Throws InputError that names file and line.
  [[noreturn]] void fail(std::string_view what, std::string_view expected) const;

 private:
  bool next_line(std::string_view& line);

  std::string_view text_, file_;
  std::span<const std::string_view> columns_;
  std::size_t line_number_ = 0, n_fields_ = 0;
  std::vector<std::optional<std::size_t>> place_;  // of each column among the fields
  std::vector<std::string_view> fields_;
};

}  // namespace warpgrain
