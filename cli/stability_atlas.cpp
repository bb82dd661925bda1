#include "cli/stability_atlas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/limit_search.hpp"
#include "core/error.hpp"

namespace warpgrain::cli {
namespace {

using reports::StabilityReport;
using reports::Verdict;

double end_of(const Probe& probe, std::uint64_t rest_steps) {
  return probe.to_rest_steps ? static_cast<double>(rest_steps) : probe.to;
}

StabilityReport::Sample sample_at(const Probe& probe, const ProbeBench& bench, double x) {
  StabilityReport::Sample sample;
  sample.x = x;
  try {
    const ProbeReading reading = probe.read(bench, x);
    sample.text = reading.what;
    if (std::isfinite(reading.error)) sample.error = reading.error;
    sample.verdict = !sample.error                            ? Verdict::wrong
                     : *sample.error <= probe.right_within    ? Verdict::right
                     : *sample.error <= probe.degraded_within ? Verdict::degraded
                                                              : Verdict::wrong;
  } catch (const InputError& error) {
    sample.verdict = Verdict::refused;
    sample.text = error.what();
  }
  return sample;
}

}  // namespace

StabilityReport::Probe described(const Probe& probe, std::uint64_t rest_steps) {
  return {std::string(probe.name),
          std::string(probe.summary),
          std::string(probe.parameter),
          std::string(probe.unit),
          std::string(probe.invariant),
          probe.from,
          end_of(probe, rest_steps),
          probe.right_within,
          probe.degraded_within,
          std::string(probe.other_unit),
          probe.others_in_unit == nullptr ? 0 : probe.others_in_unit()};
}

StabilityReport::Cell find_cell(const Probe& probe, const ProbeBench& bench, const AtlasOptions& options) {
  StabilityReport::Cell cell;
  cell.probe = probe.name;
  cell.variant = bench.variant().name();
  cell.backend = bench.backend().name;
  if (probe.needs_friction && bench.model() == ContactModel::simple) {
    cell.verdict = Verdict::not_applicable;
    return cell;
  }
  const auto error_at = [&](double x) {
    cell.samples.push_back(sample_at(probe, bench, x));
    const StabilityReport::Sample& sample = cell.samples.back();
    return sample.error.value_or(std::numeric_limits<double>::infinity());
  };
  const std::array bounds{probe.right_within, probe.degraded_within};
  const double to = end_of(probe, bench.rest_steps());
  const std::vector<Limit> limits =
      find_limits(error_at, {probe.from, to, options.samples, options.halvings}, bounds);
  cell.right_until = limits[0].until;
  cell.right_beyond = limits[0].beyond;
  cell.degraded_until = limits[1].until;
  cell.degraded_beyond = limits[1].beyond;
  std::ranges::sort(cell.samples,
                    [&](const auto& a, const auto& b) { return probe.from < to ? a.x < b.x : a.x > b.x; });
  for (const StabilityReport::Sample& sample : cell.samples)
    cell.verdict = std::max(cell.verdict, sample.verdict);
  return cell;
}

}  // namespace warpgrain::cli
