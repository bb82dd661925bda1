#include <fmt/format.h>
#include <set>

#include "reports/html/page.hpp"
#include "reports/html/provenance.hpp"
#include "reports/html/views.hpp"
#include "reports/weights_text.hpp"

namespace warpgrain::reports::html {

std::string provenance_view(const Report& report) {
  Provenance entries{{"format", std::string(report_format)}};
  for (const std::string& line : weights_lines(report)) entries.emplace_back("instructions", line);
  entries.emplace_back("seed", seed_text(report.seed));
  if (report.machine) entries.emplace_back("machine", report.machine->name);
  std::set<std::string> seen;  // what launches share is said once
  for (const LaunchReport& launch : report.launches) {
    if (seen.insert(launch.counters.policy).second)
      entries.emplace_back(
          "policy", fmt::format("{}, {} lanes a warp", launch.counters.policy, launch.counters.warp_width));
    if (!seen.insert(launch.source.hash).second) continue;
    entries.emplace_back("source", fmt::format("{}  {}", launch.source.name, launch.source.hash));
    entries.emplace_back("compiler", launch.source.compiler);
    entries.emplace_back("options", launch.source.command);
    entries.emplace_back("PTX", launch.ptx.file);
  }
  std::string html = provenance(report.generator, report.command_line, entries);
  html += "<h2>What they do not say</h2>\n<ul>\n";
  for (const std::string& limit : report.limits) html += fmt::format("<li>{}</li>\n", escape(limit));
  return html + "</ul>\n";
}

}  // namespace warpgrain::reports::html
