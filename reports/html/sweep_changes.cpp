#include "reports/html/sweep_changes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "reports/html/page.hpp"
#include "reports/html/table.hpp"
#include "reports/sweep_columns.hpp"

namespace warpgrain::reports::html {
namespace {

constexpr double full_shade = 0.2;  // of a change for the worse

// From -1 to +infinity; none where either has no value, or the earlier is zero.
std::optional<double> change_of(const SweepColumn& column, const SweepCase& now, const SweepCase& before) {
  const auto value = column.value(now), earlier = column.value(before);
  if (!value || !earlier) return std::nullopt;
  if (*value == *earlier) return 0;
  return *earlier == 0 ? std::nullopt : std::optional(*value / *earlier - 1);
}

Cell change_cell(const SweepColumn& column, const SweepCase& now, const SweepCase& before) {
  const std::optional<double> change = change_of(column, now, before);
  Cell cell = text_cell(!change ? "-" : *change == 0 ? "same" : fmt::format("{:+.2f} %", 100 * *change));
  cell.html = fmt::format("<span title=\"{} before, {} now\">{}</span>", escape(column.text(before)),
                          escape(column.text(now)), cell.html);
  cell.sort_by = change;
  if (change) cell.heat = std::clamp((column.higher_is_better ? -*change : *change) / full_shade, 0.0, 1.0);
  return cell;
}

const SweepCase* case_of(const SweepIndex& index, const std::string& variant) {
  const auto found = std::ranges::find(index.cases, variant, &SweepCase::variant);
  return found == index.cases.end() ? nullptr : &*found;
}

std::string only_in(const char* text, const SweepIndex& index, const SweepIndex& other) {
  std::string names;
  std::size_t n = 0;
  for (const SweepCase& sweep_case : index.cases)
    if (case_of(other, sweep_case.variant) == nullptr) {
      names += fmt::format("<li class=\"mono\">{}</li>\n", escape(sweep_case.variant));
      ++n;
    }
  if (n == 0) return {};
  return fmt::format(
      "<details><summary>{} <span class=\"soft\">{}</span></summary>\n<ul>\n{}</ul></details>\n", text, n,
      names);
}

}  // namespace

std::string sweep_changes(const SweepIndex& index, const SweepIndex& baseline) {
  std::vector<SweepColumn> columns = sweep_columns(index);
  std::vector<std::pair<const SweepCase*, const SweepCase*>> shared;
  for (const SweepCase& now : index.cases)
    if (const SweepCase* before = case_of(baseline, now.variant)) shared.emplace_back(&now, before);
  std::erase_if(columns, [&](const SweepColumn& column) {
    return std::ranges::none_of(
        shared, [&](const auto& pair) { return change_of(column, *pair.first, *pair.second).has_value(); });
  });
  std::vector<Table::Column> headings{{"variant", "of both sweeps", true}};
  for (const SweepColumn& column : columns)
    headings.push_back(
        {std::string(column.heading), fmt::format("{}; change from the baseline", column.explanation)});
  Table table(headings);
  for (const auto& [now, before] : shared) {
    std::vector<Cell> row{{fmt::format("<span class=\"mono\">{}</span>", escape(now->variant)), {}, {}}};
    for (const SweepColumn& column : columns) row.push_back(change_cell(column, *now, *before));
    table.add_row(row);
  }
  return fmt::format(
             "<h2>What changed</h2>\n<p class=\"soft\">Against {}, made by revision {} with <code>{}</code>. "
             "Shaded: for the "
             "worse, by {:.0f} % and more in full.</p>\n{}",
             escape(title_of(baseline)), escape(baseline.generator.git_revision),
             escape(baseline.command_line), 100 * full_shade,
             shared.empty() ? "<p>No variant is in both.</p>\n" : table.html()) +
         only_in("Not in the baseline", index, baseline) + only_in("Only in the baseline", baseline, index);
}

}  // namespace warpgrain::reports::html
