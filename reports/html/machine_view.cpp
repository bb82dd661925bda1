#include <fmt/format.h>

#include "analysis/sfu_cost.hpp"
#include "reports/html/page.hpp"
#include "reports/html/table.hpp"
#include "reports/html/views.hpp"

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
      "32-bit arithmetic.</p>\n{}<details><summary>The machine</summary>\n{}</details>\n",
      escape(machine.name), escape(machine.description), machine.lanes.value / machine.sfu_lanes.value,
      sfu_table(machine, kernels), values.html());
}

}  // namespace warpgrain::reports::html
