#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "reports/number_text.hpp"
#include "reports/paper_report.hpp"
#include "reports/text_state_samples.hpp"
#include "reports/text_table.hpp"

namespace warpgrain::reports {
namespace {

std::string value_text(double value) {
  return std::abs(value) >= 1e5 ? count_text(static_cast<std::uint64_t>(std::llround(value)))
                                : fmt::format("{:.4g}", value);
}

std::string value_text(const std::optional<double>& value) { return value ? value_text(*value) : "-"; }

// A line for each measured value.
std::string rows_table(const PaperReport& report) {
  using enum TextTable::Align;
  TextTable table({{"quantity", left}, {"paper"}, {"model"}, {"simulated"}, {"measured"}, {"on", left}});
  std::string section;
  for (const PaperReport::Row& row : report.rows) {
    if (row.section != section) {
      section = row.section;
      table.add_row({section, "", "", "", "", ""});
    }
    std::string name = "  " + row.quantity;
    if (!row.unit.empty()) name += fmt::format(" [{}]", row.unit);
    const std::size_t lines = std::max<std::size_t>(1, row.measured.size());
    for (std::size_t k = 0; k < lines; ++k) {
      const bool first = k == 0;
      const bool has = k < row.measured.size();
      table.add_row({first ? name : "", first ? value_text(row.paper) : "",
                     first ? value_text(row.model) : "", first ? value_text(row.simulated) : "",
                     has ? value_text(row.measured[k].value) : "-", has ? row.measured[k].on : ""});
    }
  }
  return table.text();
}

std::string remarks(const PaperReport& report) {
  std::string text;
  for (const PaperReport::Row& row : report.rows)
    if (!row.remark.empty()) text += fmt::format("{}: {}\n", row.quantity, row.remark);
  return text;
}

std::string paths_table(const PaperReport& report) {
  TextTable table({{"body at", TextTable::Align::left},
                   {"branches"},
                   {"paths allowed"},
                   {"paths taken"},
                   {"passes of lanes"},
                   {"share of instructions"}});
  for (const PaperReport::Paths& paths : report.paths)
    table.add_row({paths.line == 0 ? paths.kernel : fmt::format("{}:{}", paths.file, paths.line),
                   count_text(paths.branches), value_text(std::exp2(paths.branches)), count_text(paths.paths),
                   count_text(paths.passes), percent_text(paths.instruction_share, 1)});
  return table.text();
}

}  // namespace

std::string text_paper(const PaperReport& report) {
  std::string text =
      fmt::format("Washizawa & Nakahara's figures; scene {}, {} particles\n\n{}\n{}", report.scene,
                  count_text(report.particles), rows_table(report), remarks(report));
  text += text_state_samples(report.samples);
  if (!report.paths.empty())
    text +=
        fmt::format("\nPaths of lanes through {}\n\n{}", report.paths.front().kernel, paths_table(report));
  return text;
}

}  // namespace warpgrain::reports
