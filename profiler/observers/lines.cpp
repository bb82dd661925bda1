#include "profiler/observers/lines.hpp"

#include <map>
#include <string>
#include <utility>

#include "profiler/observers/totals.hpp"

namespace warpgrain::profiler {

std::vector<LineTotals> line_totals(const KernelGraph& graph, const WarpCounters& counters) {
  std::map<std::pair<std::string, std::uint32_t>, Totals> lines;
  for (std::uint32_t b = 0; b < graph.blocks.size(); ++b)
    for (std::uint32_t i = 0; i < graph.blocks[b].instructions.size(); ++i) {
      const SourceLocation location = graph.blocks[b].instructions[i].location;
      std::pair<std::string, std::uint32_t> place;
      if (location.line != 0) place = {graph.files[location.file], location.line};
      const auto line = lines.try_emplace(place, empty_totals(counters.warp_width)).first;
      add_instruction(graph, counters, b, i, line->second);
    }
  std::vector<LineTotals> result;
  for (auto& [place, totals] : lines)
    if (totals.warp_instructions != 0) result.push_back({place.first, place.second, std::move(totals)});
  return result;
}

}  // namespace warpgrain::profiler
