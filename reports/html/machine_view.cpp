#include <algorithm>
#include <fmt/format.h>

#include "analysis/sfu_cost.hpp"
#include "reports/html/page.hpp"
#include "reports/html/table.hpp"
#include "reports/html/views.hpp"
#include "reports/number_text.hpp"

namespace warpgrain::reports::html {
namespace {

std::string sfu_table(const Machine& machine, const std::vector<KernelSummary>& kernels) {
  Table table({{"kernel", "its name in the source", true},
               Table::of_metric("sfu_instructions"),
               {"SFU cycles", "SFU instructions * warp width / SFU lanes of a multiprocessor"},
               {"issue cycles", "warp instructions / issue rate of a multiprocessor"},
               {"SFU/issue", "above 100 % the special-function units are the limit"}});
  for (const KernelSummary& kernel : kernels) {
    const SfuCost cost = sfu_cost(kernel.counters.totals, kernel.counters.warp_width, machine);
    table.add_row({text_cell(kernel.counters.kernel), count_cell(cost.instructions),
                   count_cell(static_cast<std::uint64_t>(cost.cycles)),
                   count_cell(static_cast<std::uint64_t>(cost.issue_cycles)),
                   share_cell(cost.cycles, cost.issue_cycles)});
  }
  return table.html();
}

Cell seconds_cell(double seconds) { return {seconds_text(seconds), seconds, {}}; }

// By the cost model (docs/cost-model.md); empty where the machine has no constants for it.
std::string predicted_times(const std::vector<KernelSummary>& kernels) {
  if (std::ranges::any_of(kernels, [](const KernelSummary& kernel) { return !kernel.predicted; })) return {};
  Table table({{"kernel", "its name in the source; all launches of it together", true},
               {"predicted", "time by the cost model"},
               {"start", "of the launch and its work-groups"},
               {"issue", "what issuing the instructions takes alone"},
               {"SFU", "what the special-function units take alone"},
               {"cache lines", "what requests take alone, a line at a time"},
               {"memory", "what moving the sectors takes alone"},
               {"latency", "what waiting takes that other warps do not hide"},
               {"resident warps", "of a multiprocessor"}});
  double all = 0;
  for (const KernelSummary& kernel : kernels) {
    const PredictedTime& time = *kernel.predicted;
    all += time.seconds;
    table.add_row({text_cell(kernel.counters.kernel), seconds_cell(time.seconds), seconds_cell(time.start),
                   seconds_cell(time.issue), seconds_cell(time.sfu), seconds_cell(time.lines),
                   seconds_cell(time.memory), seconds_cell(time.latency),
                   number_cell(time.resident_warps, 0)});
  }
  return fmt::format(
      "<p>Predicted time of all launches: {}; beside, what each part would take alone.</p>\n{}",
      seconds_text(all), table.html());
}

}  // namespace

std::string machine_view(const Report& report, const std::vector<KernelSummary>& kernels) {
  if (!report.machine) return {};
  const Machine& machine = *report.machine;
  Table values({{"machine", "a number of the machine file", true},
                {"value", "in units of the SI"},
                {"source", "where the number was published", true}});
  for (const MachineKey& key : machine_keys) {
    const MachineValue& value = machine.*key.value;
    values.add_row({text_cell(key.key), text_cell(fmt::format("{}", value.value)), text_cell(value.source)});
  }
  return fmt::format(
      "<h2>On {}</h2>\n<p>{}. An instruction on the special-function units (SFU) takes {:.3g} times the "
      "cycles of "
      "32-bit arithmetic.</p>\n{}{}<details><summary>The machine</summary>\n{}</details>\n",
      escape(machine.name), escape(machine.description), machine.lanes.value / machine.sfu_lanes.value,
      sfu_table(machine, kernels), predicted_times(kernels), values.html());
}

}  // namespace warpgrain::reports::html
