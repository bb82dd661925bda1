#include "reports/table_files.hpp"

#include <fmt/format.h>
#include <set>

#include "reports/sweep_columns.hpp"

namespace warpgrain::reports {
namespace {

std::string csv_cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') quoted += '"';
  }
  return quoted + '"';
}

std::string markdown_cell(std::string_view text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') cell += '\\';
    cell += c == '\n' ? ' ' : c;
  }
  return cell;
}

}  // namespace

std::string csv_sweep(const SweepIndex& index) {
  const std::vector<SweepColumn> columns = sweep_columns(index);
  std::set<std::string> axes;
  for (const SweepCase& sweep_case : index.cases)
    for (const auto& [axis, value] : sweep_case.axes) axes.insert(axis);
  std::string text = "variant,status";
  for (const std::string& axis : axes) text += "," + csv_cell(axis);
  for (const SweepColumn& column : columns) text += "," + csv_cell(column.heading);
  text += '\n';
  for (const SweepCase& sweep_case : index.cases) {
    text += fmt::format("{},{}", csv_cell(sweep_case.variant), case_status_name(sweep_case.status));
    for (const std::string& axis : axes) {
      const auto value = sweep_case.axes.find(axis);
      text += "," + (value == sweep_case.axes.end() ? std::string() : csv_cell(value->second));
    }
    for (const SweepColumn& column : columns) {
      const std::optional<double> value = column.value(sweep_case);
      text += value ? fmt::format(",{}", *value) : ",";
    }
    text += '\n';
  }
  return text;
}

std::string markdown_sweep(const SweepIndex& index) {
  const std::vector<SweepColumn> columns = sweep_columns(index);
  std::string text = fmt::format("{}\n\n| variant |", title_of(index));
  for (const SweepColumn& column : columns) text += fmt::format(" {} |", markdown_cell(column.heading));
  text += "\n|---|";
  for (std::size_t k = 0; k < columns.size(); ++k) text += "---:|";
  text += '\n';
  for (const SweepCase& sweep_case : index.cases) {
    text += fmt::format("| `{}` |", markdown_cell(sweep_case.variant));
    for (const SweepColumn& column : columns)
      text += fmt::format(" {} |", markdown_cell(column.text(sweep_case)));
    text += '\n';
  }
  for (const std::string& line : notes_of(index)) text += "\n" + line + "\n";
  for (const std::string& line : troubles_of(index)) text += "\n" + line + "\n";
  return text;
}

}  // namespace warpgrain::reports
