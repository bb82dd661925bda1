#include "reports/text_sweep.hpp"

#include <fmt/format.h>

#include "reports/sweep_columns.hpp"
#include "reports/text_table.hpp"

namespace warpgrain::reports {

std::string text_sweep(const SweepIndex& index) {
  const std::vector<SweepColumn> shown = sweep_columns(index);
  std::vector<TextTable::Column> columns{{"variant", TextTable::Align::left}};
  for (const SweepColumn& column : shown)
    columns.push_back({std::string(column.heading), TextTable::Align::right});
  TextTable table(columns);
  for (const SweepCase& sweep_case : index.cases) {
    std::vector<std::string> row{sweep_case.variant};
    for (const SweepColumn& column : shown) row.push_back(column.text(sweep_case));
    table.add_row(row);
  }
  std::string text = fmt::format("{}\n\n{}", title_of(index), table.text());
  for (const std::string& line : notes_of(index)) text += "\n" + line;
  for (const std::string& line : troubles_of(index)) text += "\n" + line;
  return text.ends_with('\n') ? text : text + "\n";
}

}  // namespace warpgrain::reports
