#include <fmt/format.h>
#include <set>

#include "reports/html/page.hpp"
#include "reports/html/views.hpp"
#include "reports/weights_text.hpp"

namespace warpgrain::reports::html {
namespace {

std::string entry(std::string_view name, std::string_view value) {
  return fmt::format("<dt>{}</dt><dd><code>{}</code></dd>\n", escape(name), escape(value));
}

}  // namespace

std::string provenance_view(const Report& report) {
  std::string html = "<h2>Where these numbers come from</h2>\n<dl>\n";
  html += entry("warpgrain",
                fmt::format("{}, revision {}", report.generator.version, report.generator.git_revision));
  html += entry("command", report.command_line);
  html += entry("format", report_format);
  for (const std::string& line : weights_lines(report)) html += entry("instructions", line);
  if (report.machine) html += entry("machine", report.machine->name);
  std::set<std::string> seen;  // what launches share is said once
  for (const LaunchReport& launch : report.launches) {
    if (seen.insert(launch.counters.policy).second)
      html += entry("policy",
                    fmt::format("{}, {} lanes a warp", launch.counters.policy, launch.counters.warp_width));
    if (!seen.insert(launch.source.hash).second) continue;
    html += entry("source", fmt::format("{}  {}", launch.source.name, launch.source.hash));
    html += entry("compiler", launch.source.compiler);
    html += entry("options", launch.source.command);
    if (!launch.ptx.file.empty()) html += entry("PTX", launch.ptx.file);
  }
  html += "</dl>\n<h2>What they do not say</h2>\n<ul>\n";
  for (const std::string& limit : report.limits) html += fmt::format("<li>{}</li>\n", escape(limit));
  return html + "</ul>\n";
}

}  // namespace warpgrain::reports::html
