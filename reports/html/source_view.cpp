#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <utility>
#include <vector>

#include "reports/html/page.hpp"
#include "reports/html/table.hpp"
#include "reports/html/views.hpp"
#include "reports/number_text.hpp"

namespace warpgrain::reports::html {
namespace {

using profiler::LineTotals;
using profiler::Totals;

constexpr std::size_t context = 2;  // lines without instructions that stay beside lines with some
constexpr std::string_view empty_cells = "<td></td><td></td><td></td><td></td><td></td><td></td>";

double lost_slots(const Totals& totals, std::uint32_t warp_width) {
  return static_cast<double>(totals.warp_instructions) * warp_width -
         static_cast<double>(totals.thread_instructions);
}

double sectors(const Totals& totals) {
  return static_cast<double>(totals.global_load.sectors + totals.global_store.sectors +
                             totals.atomic.sectors);
}

std::vector<Table::Column> columns_of_source() {
  const auto sectors_of = [](const char* key) { return metric(key).ncu_metric; };
  return {Table::of_metric("warp_instructions"),
          Table::of_metric("active_lanes"),
          {"by active lanes", std::string(metric("lane_histogram").definition)},
          Table::of_metric("lane_slots_idle"),
          Table::of_metric("sfu_instructions"),
          {"sectors",
           fmt::format("32-byte sectors that loads, stores and atomics of global memory touched, request by "
                       "request\nNsight Compute: {}, {}; none for atomics",
                       sectors_of("global_load_sectors"), sectors_of("global_store_sectors"))},
          {"line", "of the file that is named above it"},
          {"code", "a branch is named by its // branch: comment", true}};
}

// The largest value of each column, which is its full shade.
struct Scale {
  double warp_instructions = 0, lost = 0, sfu = 0, sectors = 0;
};

Scale scale_of(const profiler::LaunchCounters& counters) {
  Scale scale;
  for (const LineTotals& line : counters.lines) {
    const Totals& t = line.totals;
    scale.warp_instructions = std::max(scale.warp_instructions, static_cast<double>(t.warp_instructions));
    scale.lost = std::max(scale.lost, lost_slots(t, counters.warp_width));
    scale.sfu = std::max(scale.sfu, static_cast<double>(t.sfu_instructions));
    scale.sectors = std::max(scale.sectors, sectors(t));
  }
  return scale;
}

std::string heat_cell(const std::string& text, double value, double largest) {
  if (value == 0) return "<td></td>";
  return fmt::format("<td class=\"heat\" style=\"--h:{:.3f}\">{}</td>", largest == 0 ? 0 : value / largest,
                     text);
}

std::string cells_of(const Totals& t, const Scale& scale, std::uint32_t warp_width) {
  if (t.warp_instructions == 0) return std::string(empty_cells);
  const auto issued = static_cast<double>(t.warp_instructions);
  const double lost = lost_slots(t, warp_width);
  // Few active lanes are hot; the shade is the share of idle lanes.
  return heat_cell(count_text(t.warp_instructions), issued, scale.warp_instructions) +
         fmt::format("<td class=\"heat\" style=\"--h:{:.3f}\">{}</td>", 1 - t.simt_efficiency(warp_width),
                     fixed_text(t.active_lanes(), 1)) +
         fmt::format("<td>{}</td>", lanes_bars(t.lane_histogram)) +
         heat_cell(count_text(static_cast<std::uint64_t>(lost)), lost, scale.lost) +
         heat_cell(count_text(t.sfu_instructions), static_cast<double>(t.sfu_instructions), scale.sfu) +
         heat_cell(count_text(static_cast<std::uint64_t>(sectors(t))), sectors(t), scale.sectors);
}

std::string gap_row(std::size_t lines) {
  return fmt::format("<tr class=\"gap\"><td colspan=\"8\">{} {} without instructions</td></tr>\n", lines,
                     lines == 1 ? "line" : "lines");
}

std::string row(std::string_view cells, std::uint32_t number, std::string_view code) {
  return fmt::format("<tr>{}<td class=\"number\">{}</td><td class=\"code\">{}</td></tr>\n", cells, number,
                     escape(code));
}

std::string file_row(std::string_view file) {
  return fmt::format("<tr><td class=\"text\" colspan=\"8\"><b>{}</b></td></tr>\n", escape(file));
}

using Counts = std::map<std::pair<std::string_view, std::uint32_t>, const LineTotals*>;

// Takes the lines that it shows out of `counts`: what is left stands nowhere in the source.
std::string source_rows(const KernelSummary& kernel, const Scale& scale, Counts& counts) {
  std::vector<SourceLine> lines = lines_of(kernel.source->name, kernel.source->text);
  std::erase_if(lines, [](const SourceLine& line) { return line.directive; });
  std::vector<const LineTotals*> totals(lines.size(), nullptr);
  std::vector<bool> shown(lines.size(), false);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto found = counts.find({lines[k].file, lines[k].line});
    if (found == counts.end()) continue;
    totals[k] = found->second;
    counts.erase(found);
    for (std::size_t near = k - std::min(k, context); near < std::min(lines.size(), k + context + 1); ++near)
      if (lines[near].file == lines[k].file) shown[near] = true;
  }
  std::string html;
  std::string_view file;
  std::size_t gap = 0;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (!shown[k]) {
      ++gap;
      continue;
    }
    if (gap > 0) html += gap_row(gap);
    gap = 0;
    if (lines[k].file != file) html += file_row(file = lines[k].file);
    html += row(totals[k] ? cells_of(totals[k]->totals, scale, kernel.counters.warp_width) : empty_cells,
                lines[k].line, lines[k].text);
  }
  return gap > 0 ? html + gap_row(gap) : html;
}

}  // namespace

std::string source_view(const KernelSummary& kernel) {
  Counts counts;
  for (const LineTotals& line : kernel.counters.lines) counts[{line.file, line.line}] = &line;
  const Scale scale = scale_of(kernel.counters);
  std::string html =
      "<h3>Source</h3>\n<p class=\"soft\">Each column is shaded by its own largest value; active lanes by "
      "how few they are. A click on a line shows its active lanes.</p>\n"
      "<div class=\"scroll\"><table class=\"source\">\n<thead><tr>";
  for (const Table::Column& column : columns_of_source()) html += Table::heading_html(column);
  html += "</tr></thead>\n<tbody>\n";
  html += source_rows(kernel, scale, counts);
  if (!counts.empty()) html += file_row("not in this source");
  for (const auto& [place, line] : counts)
    html += row(cells_of(line->totals, scale, kernel.counters.warp_width), line->line,
                line->line == 0 ? "instructions without a line" : line->file);
  return html + "</tbody></table></div>\n";
}

}  // namespace warpgrain::reports::html
