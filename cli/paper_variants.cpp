#include "cli/paper_variants.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

#include "analysis/least_time.hpp"
#include "cli/interrupt.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {
namespace {

using Row = reports::PaperReport::Row;

std::string section_of(const Machine& machine) {
  return fmt::format("{} step on {}", machine.cost ? "predicted" : "least", machine.name);
}

double milliseconds(const std::vector<profiler::LaunchProfile>& launches, const ProfiledState& left,
                    const Scene& scene, const Machine& machine) {
  if (const auto predicted = predicted_seconds(launches, left, scene, machine)) return 1e3 * *predicted;
  double least = 0;
  for (const profiler::LaunchProfile& launch : launches)
    least += least_time(launch.counters.totals, launch.counters.warp_width, machine).seconds();
  return 1e3 * least;
}

}  // namespace

VariantRows variant_rows(const Scene& scene, const std::vector<Variant>& variants,
                         const std::vector<Machine>& machines, const BackendOptions& backend,
                         const MeasuredSteps& measured, std::span<const Row> earlier, Progress& progress) {
  profiler::ProfileOptions how;
  how.checks = profiler::Checks::off;
  how.footprint = true;
  how.threads = backend.threads;
  VariantRows result;
  std::vector<std::vector<Row>> of_machine(machines.size());
  for (const Variant& variant : variants) {
    const std::string name = variant.name();
    std::vector<profiler::LaunchProfile> launches;  // of variants that `earlier` has not
    ProfiledState left;
    std::vector<Row> rows;
    for (const Machine& machine : machines) {
      const std::string section = section_of(machine);
      const auto known = std::ranges::find_if(
          earlier, [&](const Row& row) { return row.section == section && row.quantity == name; });
      if (known != earlier.end()) {
        rows.push_back(*known);
        continue;
      }
      if (launches.empty()) {
        if (interrupted()) break;
        progress.update("variants",
                        static_cast<double>(result.variants) / static_cast<double>(variants.size()), name);
        launches = profile_step(scene, variant, how, backend, {}, &left);
      }
      Row& row = rows.emplace_back();
      row.section = section;
      row.quantity = name;
      row.unit = "ms";
      row.simulated = milliseconds(launches, left, scene, machine);
      if (result.variants == 0)
        row.remark = machine.cost ? "of all variants here: by the cost model"
                                  : "of all variants here: for the instructions alone, since the machine "
                                    "file has no constants of the cost model";
      if (const auto seconds = measured.seconds(variant); seconds && &machine == &machines.back())
        row.measured.push_back({1e3 * *seconds, measured.of_what()});
    }
    if (rows.size() < machines.size()) break;
    for (std::size_t m = 0; m < machines.size(); ++m) of_machine[m].push_back(rows[m]);
    ++result.variants;
  }
  for (const auto& part : of_machine) result.rows.insert(result.rows.end(), part.begin(), part.end());
  return result;
}

}  // namespace warpgrain::cli
