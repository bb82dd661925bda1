#include <algorithm>
#include <fmt/format.h>
#include <functional>

#include "reports/accuracy_report.hpp"
#include "reports/number_text.hpp"
#include "reports/text_table.hpp"

namespace warpgrain::reports {
namespace {

template <class Part, class Member>
std::string part_text(const std::optional<Part>& part, Member member) {
  return part ? fmt::format("{:.1e}", (*part).*member) : "-";
}

std::string parted_text(const std::optional<AccuracyReport::Trajectory>& trajectory) {
  if (!trajectory) return "-";
  return trajectory->parted_at ? seconds_text(*trajectory->parted_at)
                               : "> " + seconds_text(trajectory->compared);
}

struct AccuracyColumn {
  TextTable::Column heading;
  bool is_there;
  std::function<std::string(const AccuracyReport::Case&)> text;
};

// Without those that have nothing to show.
std::string table_of(const AccuracyReport& report, const std::vector<AccuracyColumn>& all) {
  std::vector<TextTable::Column> headings;
  for (const AccuracyColumn& column : all)
    if (column.is_there) headings.push_back(column.heading);
  TextTable table(headings);
  for (const AccuracyReport::Case& row : report.cases) {
    std::vector<std::string> cells;
    for (const AccuracyColumn& column : all)
      if (column.is_there) cells.push_back(column.text(row));
    table.add_row(cells);
  }
  return table.text();
}

std::string table_of_cases(const AccuracyReport& report) {
  using enum TextTable::Align;
  using Case = AccuracyReport::Case;
  const auto has = [&](auto member) {
    return std::ranges::any_of(report.cases, [&](const Case& row) { return (row.*member).has_value(); });
  };
  const auto time = [](auto member) {
    return [member](const Case& row) { return row.*member ? seconds_text(*(row.*member)) : "-"; };
  };
  const auto per_particle = static_cast<double>(std::max<std::uint64_t>(1, report.cost_particles));
  const auto collision = [](auto member) {
    return [member](const Case& row) { return part_text(row.collision, member); };
  };
  const bool forces = has(&Case::force), collisions = has(&Case::collision);
  return table_of(
      report,
      {{{"front", left}, true, [](const Case& row) { return row.dominated_by ? "" : "*"; }},
       {{"variant", left}, true, [](const Case& row) { return row.name(); }},
       {{"on", left}, true, [](const Case& row) { return row.backend; }},
       {{"cost"},
        true,
        [](const Case& row) { return row.relative_cost > 0 ? fixed_text(row.relative_cost, 2) : "-"; }},
       {{"warp instructions/ particle"},
        true,
        [=](const Case& row) {
          return fixed_text(static_cast<double>(row.warp_instructions) / per_particle, 1);
        }},
       {{"bytes/ particle"},
        true,
        [=](const Case& row) { return fixed_text(static_cast<double>(row.bytes) / per_particle, 0); }},
       {{"time/ step"}, has(&Case::seconds), time(&Case::seconds)},
       {{"predicted/ step"}, has(&Case::predicted_seconds), time(&Case::predicted_seconds)},
       {{"measured/ step"}, has(&Case::measured_seconds), time(&Case::measured_seconds)},
       {{"force max"},
        forces,
        [](const Case& row) { return part_text(row.force, &AccuracyReport::Force::maximum); }},
       {{"force rms"},
        forces,
        [](const Case& row) { return part_text(row.force, &AccuracyReport::Force::root_mean_square); }},
       {{"max ulp"},
        forces,
        [](const Case& row) { return row.force ? fmt::format("{:.3g}", row.force->maximum_ulps) : "-"; }},
       {{"rms ulp"},
        forces,
        [](const Case& row) {
          return row.force ? fmt::format("{:.3g}", row.force->root_mean_square_ulps) : "-";
        }},
       {{"resti- tution"}, collisions, collision(&AccuracyReport::Collision::restitution)},
       {{"rebound degrees"}, collisions, collision(&AccuracyReport::Collision::rebound_angle)},
       {{"spin"}, collisions, collision(&AccuracyReport::Collision::spin)},
       {{"trajectories part"}, has(&Case::trajectory), [](const Case& row) {
          return parted_text(row.trajectory);
        }}});
}

// Means over seeds; "=" where nothing tells a mean from the reference's.
std::string table_of_ensembles(const AccuracyReport& report) {
  std::vector<TextTable::Column> headings{{"variant", TextTable::Align::left}};
  const auto found = std::ranges::find_if(
      report.cases, [](const AccuracyReport::Case& row) { return !row.ensemble.empty(); });
  if (found == report.cases.end()) return {};
  for (const auto& quantity : found->ensemble)
    headings.push_back(
        {fmt::format("{} [{}]", quantity.quantity, quantity.unit.empty() ? "1" : quantity.unit)});
  TextTable table(headings);
  for (const AccuracyReport::Case& row : report.cases) {
    std::vector<std::string> cells{row.name()};
    for (const auto& quantity : row.ensemble)
      cells.push_back(fmt::format("{:.4g} +- {:.2g} {}", quantity.mean, quantity.half_width.value_or(0),
                                  quantity.significant ? "!" : "="));
    cells.resize(headings.size(), "-");
    table.add_row(cells);
  }
  return fmt::format(
      "Means over {} seeds and their 95 % intervals; = no significant difference from the double reference, "
      "! a "
      "significant one\n\n{}\n",
      report.seeds, table.text());
}

std::string_view cost_text(std::string_view cost) {
  if (cost == "warp_instructions") return "simulated warp instructions";
  if (cost == "bytes") return "bytes of the memory sectors touched";
  if (cost == "predicted_seconds") return "predicted time";
  return cost == "measured_seconds" ? "measured time" : "time on the OpenCL device";
}

std::string head_of(const AccuracyReport& report) {
  std::string text =
      fmt::format("{}, {} particles, step {}; cost is {}", report.scene, count_text(report.particles),
                  count_text(report.step), cost_text(report.cost));
  if (report.cost_particles != report.particles)
    text += fmt::format("; costs of {} particles", count_text(report.cost_particles));
  if (!report.machine.empty()) text += fmt::format("\npredicted: {}", report.machine);
  if (!report.measured.empty()) text += fmt::format("\nmeasured: {}", report.measured);
  return text;
}

}  // namespace

std::string text_accuracy(const AccuracyReport& report) {
  std::string text =
      fmt::format("{}\n\n{}\n{}", head_of(report), table_of_cases(report), table_of_ensembles(report));
  for (const AccuracyReport::Case& row : report.cases)
    text += fmt::format("{}: {}{}\n", row.name(), sentence_of(row),
                        row.dominated_by ? fmt::format("; dominated by {}", *row.dominated_by) : "");
  return text;
}

}  // namespace warpgrain::reports
