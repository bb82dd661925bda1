#include "reports/diagnostic_summary.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "profiler/diagnostic.hpp"

namespace warpgrain::reports {

std::vector<std::string> diagnostic_lines(const Report& report) {
  using profiler::Diagnostic;
  std::vector<std::pair<std::string, Diagnostic>> found;  // kernel, the first of its sort
  std::vector<std::string> given_up;
  for (const LaunchReport& launch : report.launches) {
    for (const Diagnostic& d : launch.counters.diagnostics) {
      const auto same = std::find_if(found.begin(), found.end(), [&](const auto& other) {
        return other.first == launch.counters.kernel && other.second.kind == d.kind &&
               other.second.place == d.place && other.second.buffer == d.buffer;
      });
      if (same == found.end())
        found.emplace_back(launch.counters.kernel, d);
      else
        same->second.count += d.count;
    }
    if (launch.counters.given_up)
      given_up.push_back(
          fmt::format("kernel '{}': the launch was given up, too many work-items had to be stopped",
                      launch.counters.kernel));
  }
  std::vector<std::string> lines;
  for (const auto& [kernel, diagnostic] : found) lines.push_back(profiler::diagnostic_text(diagnostic));
  lines.insert(lines.end(), given_up.begin(), given_up.end());
  return lines;
}

}  // namespace warpgrain::reports
