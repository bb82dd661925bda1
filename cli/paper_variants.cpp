#include "cli/paper_variants.hpp"

#include <fmt/format.h>

#include "analysis/least_time.hpp"
#include "cli/output.hpp"
#include "reports/report.hpp"
#include "reports/summary.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {

std::vector<reports::PaperReport::Row> variant_rows(const Scene& scene, const std::vector<Variant>& variants,
                                                    const std::vector<Machine>& machines,
                                                    const BackendOptions& backend,
                                                    const MeasuredSteps& measured, Progress& progress) {
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
      if (const auto seconds = measured.seconds(variants[k]); seconds && &machine == &machines.back())
        row.measured.push_back({1e3 * *seconds, measured.of_what()});
    }
  }
  return rows;
}

}  // namespace warpgrain::cli
