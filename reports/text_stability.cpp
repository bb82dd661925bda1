#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "reports/stability_report.hpp"

namespace warpgrain::reports {
namespace {

using Cells = std::vector<const StabilityReport::Cell*>;

// Those whose limits are alike: the same verdict, and right to the same two digits.
std::vector<Cells> alike(const StabilityReport& report, const StabilityReport::Probe& probe) {
  std::vector<Cells> groups;
  std::map<std::string, std::size_t> known;
  for (const StabilityReport::Cell& cell : report.cells) {
    if (cell.probe != probe.name) continue;
    const std::string key =
        fmt::format("{} {:.2g}", verdict_name(cell.verdict), cell.right_until.value_or(0));
    const auto [place, is_new] = known.emplace(key, groups.size());
    if (is_new) groups.emplace_back();
    groups[place->second].push_back(&cell);
  }
  return groups;
}

bool has_one_backend(const StabilityReport& report) {
  return std::ranges::all_of(report.cells, [&](const StabilityReport::Cell& cell) {
    return cell.backend == report.cells.front().backend;
  });
}

// The larger part of all is not listed.
std::string names_of(const Cells& cells, std::size_t all, bool with_backends) {
  if (all > 2 && cells.size() == all) return fmt::format("all {}", all);
  if (cells.size() > 3 && 2 * cells.size() > all) return fmt::format("the other {} of {}", cells.size(), all);
  std::string text;
  for (const StabilityReport::Cell* cell : cells)
    text += fmt::format("{}{}{}", text.empty() ? "" : ", ", cell->variant,
                        with_backends ? fmt::format(" ({})", cell->backend) : "");
  return text;
}

}  // namespace

std::string text_stability(const StabilityReport& report) {
  std::string text;
  for (const StabilityReport::Probe& probe : report.probes) {
    const std::string unit = probe.unit.empty() ? "" : fmt::format(" [{}]", probe.unit);
    text += fmt::format("{}: {}\n  {}{} from {:.3g} to {:.3g}; {}\n", probe.name, probe.summary,
                        probe.parameter, unit, probe.from, probe.to, probe.invariant);
    const std::vector<Cells> groups = alike(report, probe);
    std::size_t all = 0;
    for (const Cells& cells : groups) all += cells.size();
    for (const Cells& cells : groups)
      text += fmt::format("    {}\n      {}\n", limits_text(probe, *cells.front()),
                          names_of(cells, all, !has_one_backend(report)));
    text += "\n";
  }
  std::map<Verdict, int> counts;
  for (const StabilityReport::Cell& cell : report.cells) ++counts[cell.verdict];
  for (const auto& [verdict, count] : counts)
    text +=
        fmt::format("{}{} {}", verdict == counts.begin()->first ? "" : ", ", count, verdict_name(verdict));
  return text + "\n";
}

namespace {

std::string markdown_limit(const std::optional<double>& until, bool is_whole_range,
                           const StabilityReport::Probe& probe) {
  if (is_whole_range) return "all of it";
  if (!until) return "-";
  if (probe.other_unit.empty()) return fmt::format("{:.2g}", *until);
  return fmt::format("{:.2g} ({:.2g} {})", *until, *until * probe.others_in_unit, probe.other_unit);
}

// Where it is no longer even degraded.
std::string what_then(const StabilityReport::Cell& cell) {
  if (!cell.degraded_beyond) return "";
  for (const StabilityReport::Sample& sample : cell.samples)
    if (sample.x == *cell.degraded_beyond)
      return fmt::format("{}: {}", verdict_name(sample.verdict), sample.text);
  return "";
}

}  // namespace

std::string markdown_stability(const StabilityReport& report) {
  std::string text =
      "| probe | from, to | right to | degraded to | then | variants |\n|---|---|---:|---:|---|---|\n";
  for (const StabilityReport::Probe& probe : report.probes) {
    const std::vector<Cells> groups = alike(report, probe);
    std::size_t all = 0;
    for (const Cells& cells : groups) all += cells.size();
    for (const Cells& cells : groups) {
      const StabilityReport::Cell& cell = *cells.front();
      const std::string names = names_of(cells, all, !has_one_backend(report));
      if (cell.verdict == Verdict::not_applicable) {
        text += fmt::format("| {} | | | | not applicable | {} |\n", probe.name, names);
        continue;
      }
      text += fmt::format("| {} | {:.3g} to {:.3g} {} | {} | {} | {} | {} |\n", probe.name, probe.from,
                          probe.to, probe.unit, markdown_limit(cell.right_until, !cell.right_beyond, probe),
                          markdown_limit(cell.degraded_until, !cell.degraded_beyond, probe), what_then(cell),
                          names);
    }
  }
  text += "\n";
  for (const StabilityReport::Probe& probe : report.probes)
    text += fmt::format("* `{}`: {}; what has to hold: {}\n", probe.name, probe.summary, probe.invariant);
  return text;
}

}  // namespace warpgrain::reports
