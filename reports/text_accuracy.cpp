#include <fmt/format.h>

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

}  // namespace

std::string text_accuracy(const AccuracyReport& report) {
  using enum TextTable::Align;
  TextTable table({{"front", left},
                   {"variant", left},
                   {"on", left},
                   {"cost"},
                   {"bytes/ particle"},
                   {"time/ step"},
                   {"force max"},
                   {"force rms"},
                   {"max ulp"},
                   {"resti- tution"},
                   {"rebound degrees"},
                   {"spin"},
                   {"trajectories part"}});
  for (const AccuracyReport::Case& row : report.cases)
    table.add_row({row.dominated_by ? "" : "*", row.name(), row.backend, fixed_text(row.relative_cost, 2),
                   count_text(row.bytes / std::max<std::uint64_t>(1, report.particles)),
                   row.seconds ? seconds_text(*row.seconds) : "-",
                   part_text(row.force, &AccuracyReport::Force::maximum),
                   part_text(row.force, &AccuracyReport::Force::root_mean_square),
                   row.force ? fmt::format("{:.3g}", row.force->maximum_ulps) : "-",
                   part_text(row.collision, &AccuracyReport::Collision::restitution),
                   part_text(row.collision, &AccuracyReport::Collision::rebound_angle),
                   part_text(row.collision, &AccuracyReport::Collision::spin), parted_text(row.trajectory)});
  std::string text = fmt::format("{}, {} particles, step {}\n\n{}\n", report.scene,
                                 count_text(report.particles), count_text(report.step), table.text());
  for (const AccuracyReport::Case& row : report.cases)
    text += fmt::format("{}: {}{}\n", row.name(), sentence_of(row),
                        row.dominated_by ? fmt::format("; dominated by {}", *row.dominated_by) : "");
  return text;
}

}  // namespace warpgrain::reports
