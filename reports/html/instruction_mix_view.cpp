#include "reports/html/table.hpp"
#include "reports/html/views.hpp"

namespace warpgrain::reports::html {

std::string instruction_mix_view(const profiler::Totals& totals) {
  Table table({{"class", "what the instructions do", true},
               Table::of_metric("warp_instructions"),
               {"share", "of the warp instructions"},
               Table::of_metric("thread_instructions"),
               Table::of_metric("active_lanes")});
  for (std::size_t c = 0; c < totals.instruction_mix.size(); ++c) {
    const profiler::InstructionCount& count = totals.instruction_mix[c];
    if (count.warp == 0) continue;
    table.add_row({text_cell(profiler::instruction_class_name(static_cast<profiler::InstructionClass>(c))),
                   count_cell(count.warp),
                   share_cell(static_cast<double>(count.warp), static_cast<double>(totals.warp_instructions)),
                   count_cell(count.thread),
                   number_cell(static_cast<double>(count.thread) / static_cast<double>(count.warp), 1)});
  }
  return "<h3>Instruction mix</h3>\n" + table.html();
}

}  // namespace warpgrain::reports::html
