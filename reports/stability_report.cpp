#include "reports/stability_report.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain::reports {

std::string_view verdict_name(Verdict verdict) { return verdict_names[static_cast<std::size_t>(verdict)]; }

const StabilityReport::Sample* first_not_right(const StabilityReport::Cell& cell) {
  const auto found = std::ranges::find_if(
      cell.samples, [](const StabilityReport::Sample& sample) { return sample.verdict != Verdict::right; });
  return found == cell.samples.end() ? nullptr : &*found;
}

const StabilityReport::Probe& probe_of(const StabilityReport& report, const StabilityReport::Cell& cell) {
  const auto found = std::ranges::find(report.probes, cell.probe, &StabilityReport::Probe::name);
  if (found == report.probes.end())
    throw_input_error("stability report", fmt::format("a cell of probe '{}'", cell.probe),
                      "a probe of the report");
  return *found;
}

std::string limits_text(const StabilityReport::Probe& probe, const StabilityReport::Cell& cell) {
  if (cell.verdict == Verdict::not_applicable) return "not applicable";
  const auto limit = [&](double x) {
    return probe.other_unit.empty()
               ? fmt::format("{:.2g}", x)
               : fmt::format("{:.2g} ({:.2g} {})", x, x * probe.others_in_unit, probe.other_unit);
  };
  if (!cell.right_beyond) return fmt::format("right to {:.3g}", probe.to);
  std::string text = cell.right_until ? "right to " + limit(*cell.right_until) : std::string("nowhere right");
  if (!cell.degraded_beyond) return fmt::format("{}, degraded to {:.3g}", text, probe.to);
  if (cell.degraded_until && cell.degraded_until != cell.right_until)
    text += ", degraded to " + limit(*cell.degraded_until);
  for (const StabilityReport::Sample& sample : cell.samples)
    if (sample.x == *cell.degraded_beyond)
      text += fmt::format(", then {}: {}", verdict_name(sample.verdict), sample.text);
  return text;
}

double share_of_range(const StabilityReport::Probe& probe, const StabilityReport::Cell& cell) {
  if (!cell.right_beyond) return 1;
  if (!cell.right_until) return 0;
  return std::log(*cell.right_until / probe.from) / std::log(probe.to / probe.from);
}

}  // namespace warpgrain::reports
