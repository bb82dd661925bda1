#include "reports/text_run.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "reports/number_text.hpp"
#include "reports/text_table.hpp"

namespace warpgrain::reports {
namespace {

std::string kernel_table(const RunReport& run) {
  double all = 0;
  for (const RunReport::Kernel& kernel : run.kernels) all += kernel.seconds;
  TextTable table({{"kernel", TextTable::Align::left}, {"calls"}, {"per call"}, {"share"}});
  for (const RunReport::Kernel& kernel : run.kernels)
    table.add_row({kernel.name, count_text(kernel.calls),
                   kernel.calls ? seconds_text(kernel.seconds / static_cast<double>(kernel.calls)) : "-",
                   percent_text(kernel.seconds, all)});
  return table.text();
}

// The ends of the run and what lies evenly between them.
std::string energy_table(const RunReport& run) {
  constexpr std::size_t rows = 8;
  TextTable table(
      {{"step"}, {"time"}, {"translational"}, {"rotational"}, {"gravitational"}, {"elastic"}, {"total [J]"}});
  const std::size_t n = run.energy.size();
  const std::size_t shown = std::min(n, rows);
  for (std::size_t k = 0; k < shown; ++k) {
    const RunReport::Energy& e = run.energy[shown > 1 ? k * (n - 1) / (shown - 1) : 0];
    table.add_row({count_text(e.step), fmt::format("{:.4g} s", e.time),
                   fmt::format("{:.6g}", e.translational), fmt::format("{:.6g}", e.rotational),
                   fmt::format("{:.6g}", e.gravitational), fmt::format("{:.6g}", e.elastic),
                   fmt::format("{:.6g}", e.total())});
  }
  return table.text();
}

}  // namespace

std::string text_run(const RunReport& run) {
  std::string text = fmt::format("{}, {}, {} particles\n{} on {}\n", run.scene, run.variant,
                                 count_text(run.particles), run.backend, run.device);
  text += fmt::format("{} steps of {} in {}: {:.3f} million particle-steps/s{}\n", count_text(run.steps),
                      seconds_text(run.time_step), seconds_text(run.wall_seconds),
                      run.particle_steps_per_second() * 1e-6,
                      run.ended_by == RunEndReason::at_rest       ? "; ends at rest"
                      : run.ended_by == RunEndReason::interrupted ? "; interrupted"
                                                                  : "");
  text += fmt::format("{} contacts at the end\n", count_text(run.contacts));
  text += text_modelled_parts(run.model);
  if (!run.energy.empty()) text.append("\n").append(energy_table(run));
  if (!run.kernels.empty()) text.append("\n").append(kernel_table(run));
  return text;
}

}  // namespace warpgrain::reports
