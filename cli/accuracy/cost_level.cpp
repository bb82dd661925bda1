#include "cli/accuracy/cost_level.hpp"

#include <fmt/format.h>

#include "analysis/statistics.hpp"
#include "cli/list_making_of.hpp"
#include "cli/step_timing.hpp"
#include "core/error.hpp"
#include "reports/measured_report.hpp"
#include "reports/number_text.hpp"
#include "reports/predicted_times.hpp"
#include "reports/summary.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {
std::optional<double> predicted_seconds(std::span<const profiler::LaunchProfile> launches,
                                        const ProfiledState& left, const Scene& scene,
                                        const Machine& machine) {
  reports::Report report = reports::make_report(launches, {});
  report.scene = scene.name;
  report.machine = machine;
  report.list_making = list_making_of(launches, left, machine);
  return reports::headline_of(report).predicted_seconds;
}

StepCost cost_of(const AccuracySetting& setting, const Variant& variant) {
  profiler::ProfileOptions options;
  options.checks = profiler::Checks::off;
  options.threads = setting.backend.threads;
  if (setting.machine) {
    options.footprint = setting.machine->cost.has_value();
    options.warp_width = static_cast<std::uint32_t>(setting.machine->warp_width.value);
  }
  StepCost cost;
  ProfiledState left;
  const auto launches = profile_step(setting.costed, variant, options, setting.backend, {}, &left);
  for (const auto& launch : launches) {
    const profiler::Totals& totals = launch.counters.totals;
    cost.warp_instructions += totals.warp_instructions;
    cost.bytes += 32 * (totals.global_load.sectors + totals.global_store.sectors + totals.atomic.sectors);
  }
  if (setting.machine)
    cost.predicted_seconds = predicted_seconds(launches, left, setting.costed, *setting.machine);
  if (setting.timed_steps > 0 && backend("opencl").lacks().empty())
    cost.seconds = median_seconds_per_step(
        *backend("opencl").create(setting.costed, variant, setting.backend), setting.timed_steps);
  return cost;
}

MeasuredSteps::MeasuredSteps(std::span<const std::string> files) {
  for (const std::string& file : files) {
    const reports::MeasuredReport measured = reports::read_measured(file);
    if (!measured.variant || !measured.step)
      throw_input_error(file, "no step of a variant", "what `warpgrain measure --scene` writes");
    const std::string what =
        fmt::format("{}, {}, {} particles", measured.device.name, measured.scene.value_or("-"),
                    reports::count_text(measured.particles.value_or(0)));
    if (of_what_.empty()) of_what_ = what;
    if (what != of_what_) throw_input_error(file, what, fmt::format("{}, as the first", of_what_));
    const std::string name = Variant::parse(*measured.variant).name();
    if (!seconds_.emplace(name, median(measured.step->seconds)).second)
      throw_input_error(file, fmt::format("{} a second time", name), "a document a variant");
  }
}

std::optional<double> MeasuredSteps::seconds(const Variant& variant) const {
  const auto found = seconds_.find(variant.name());
  return found == seconds_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace warpgrain::cli
