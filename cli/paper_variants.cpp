#include "cli/paper_variants.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "analysis/least_time.hpp"
#include "analysis/statistics.hpp"
#include "cli/output.hpp"
#include "core/error.hpp"
#include "reports/measured_report.hpp"
#include "reports/report.hpp"
#include "reports/summary.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {

MeasuredStep measured_step(const std::string& file) {
  reports::MeasuredReport report = reports::read_measured(file);
  if (!report.step || !report.variant || report.step->seconds.empty())
    throw_input_error(file, "no time of a whole step", "a document of `warpgrain measure --scene`");
  return {*report.variant, median(report.step->seconds),
          fmt::format("{}: {}, {} of {} particles", std::filesystem::path(file).filename().string(),
                      report.device.name, report.scene.value_or("a scene"), report.particles.value_or(0))};
}

std::vector<reports::PaperReport::Row> variant_rows(const Scene& scene, const std::vector<Variant>& variants,
                                                    const std::vector<Machine>& machines,
                                                    const BackendOptions& backend,
                                                    const std::vector<MeasuredStep>& measured,
                                                    Progress& progress) {
  profiler::ProfileOptions how;
  how.checks = profiler::Checks::off;
  how.footprint = true;
  how.threads = backend.threads;
  std::vector<reports::PaperReport::Row> rows;
  for (std::size_t k = 0; k < variants.size(); ++k) {
    const std::string name = variants[k].name();
    progress.update("variants", static_cast<double>(k) / static_cast<double>(variants.size()), name);
    reports::Report report =
        reports::make_report(profile_step(scene, variants[k], how, backend), command_line());
    report.scene = scene.name;
    for (const Machine& machine : machines) {
      report.machine = machine;
      const reports::Headline headline = reports::headline_of(reports::kernels_of(report));
      double least = 0;
      for (const reports::LaunchReport& launch : report.launches)
        least += least_time(launch.counters.totals, launch.counters.warp_width, machine).seconds();
      reports::PaperReport::Row& row = rows.emplace_back();
      row.section = "variants";
      row.quantity = fmt::format("{} on {}", name, machine.name);
      row.unit = "ms";
      row.simulated = 1e3 * headline.predicted_seconds.value_or(least);
      if (headline.predicted_seconds)
        row.remark = fmt::format("predicted; at least {:.3g} ms for its instructions alone", 1e3 * least);
      else
        row.remark = "at least, for its instructions alone: the machine file has no cost constants";
      if (&machine == &machines.back())
        for (const MeasuredStep& reading : measured)
          if (reading.variant == name) row.measured.push_back({1e3 * reading.seconds, reading.on});
    }
  }
  return rows;
}

}  // namespace warpgrain::cli
