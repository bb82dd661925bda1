#include "cli/paper_variants.hpp"

#include <fmt/format.h>

#include "analysis/least_time.hpp"
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
  std::vector<std::vector<reports::PaperReport::Row>> of_machine(machines.size());
  for (std::size_t k = 0; k < variants.size(); ++k) {
    const std::string name = variants[k].name();
    progress.update("variants", static_cast<double>(k) / static_cast<double>(variants.size()), name);
    const auto launches = profile_step(scene, variants[k], how, backend);
    for (std::size_t m = 0; m < machines.size(); ++m) {
      const auto predicted = predicted_seconds(launches, scene, machines[m]);
      double least = 0;
      for (const profiler::LaunchProfile& launch : launches)
        least += least_time(launch.counters.totals, launch.counters.warp_width, machines[m]).seconds();
      reports::PaperReport::Row& row = of_machine[m].emplace_back();
      row.section = fmt::format("{} on {}", predicted ? "predicted step" : "least step", machines[m].name);
      row.quantity = name;
      row.unit = "ms";
      row.simulated = 1e3 * predicted.value_or(least);
      if (k == 0)
        row.remark = predicted ? "of all variants here: by the cost model"
                               : "of all variants here: for the instructions alone, since the machine file "
                                 "has no constants of the cost model";
      if (const auto seconds = measured.seconds(variants[k]); seconds && m + 1 == machines.size())
        row.measured.push_back({1e3 * *seconds, measured.of_what()});
    }
  }
  std::vector<reports::PaperReport::Row> rows;
  for (const auto& part : of_machine) rows.insert(rows.end(), part.begin(), part.end());
  return rows;
}

}  // namespace warpgrain::cli
