#include "reports/html/samples_view.hpp"

#include <fmt/format.h>

#include "reports/html/charts.hpp"
#include "reports/html/table.hpp"
#include "reports/number_text.hpp"

namespace warpgrain::reports::html {
namespace {

constexpr const char* time_axis = "time [s]";

std::string label_of(const StateSample& sample) { return fmt::format("step {}", count_text(sample.step)); }

XyChart efficiency_chart(std::span<const StateSample> samples) {
  XyChart chart{time_axis, "SIMT efficiency", {}, false, true};
  for (const std::string& name : heavy_kernels(samples)) {
    XyChart::Series& series = chart.series.emplace_back(XyChart::Series{name, true, {}});
    for (const StateSample& sample : samples)
      if (const StateSample::Kernel* kernel = sample.kernel_named(name))
        series.points.push_back({sample.time, kernel->simt_efficiency, label_of(sample), {}, {}});
  }
  return chart;
}

XyChart neighbours_chart(std::span<const StateSample> samples) {
  XyChart chart{time_axis, "a particle", {}, false, true};
  chart.series = {{"candidates, mean", true, {}}, {"contacts, mean", true, {}}};
  for (const StateSample& sample : samples) {
    chart.series[0].points.push_back({sample.time, sample.mean_candidates, label_of(sample), {}, {}});
    chart.series[1].points.push_back({sample.time, sample.mean_contacts, label_of(sample), {}, {}});
  }
  return chart;
}

}  // namespace

std::string samples_view(std::span<const StateSample> samples) {
  if (samples.empty()) return {};
  Table table({{"step", "the state after this many steps"},
               {"time [s]", "simulated, since the beginning"},
               Table::of_metric("simt_efficiency"),
               Table::of_metric("warp_instructions"),
               {"candidates", "other particles in the 27 cells around a particle, mean over the particles"},
               {"most candidates", "of any particle"},
               {"contacts", "of the candidates, those that overlap the particle, mean over the particles"},
               {"most contacts", "of any particle"}});
  for (const StateSample& sample : samples)
    table.add_row({count_cell(sample.step), number_cell(sample.time, 4),
                   number_cell(sample.simt_efficiency(), 3), count_cell(sample.warp_instructions()),
                   number_cell(sample.mean_candidates, 2), count_cell(sample.most_candidates),
                   number_cell(sample.mean_contacts, 2), count_cell(sample.most_contacts)});
  return "<h2>From falling to rest</h2>\n" +
         xy_chart("SIMT efficiency of the kernels with a hundredth of the warp instructions",
                  efficiency_chart(samples)) +
         xy_chart("Candidates and contacts", neighbours_chart(samples)) + table.html();
}

}  // namespace warpgrain::reports::html
