#include <fmt/format.h>

#include "reports/diagnostic_summary.hpp"
#include "reports/html/page.hpp"
#include "reports/html/views.hpp"

namespace warpgrain::reports::html {

std::string diagnostics_view(const Report& report) {
  const std::vector<std::string> lines = diagnostic_lines(report);
  if (lines.empty()) return {};
  std::string items;
  for (const std::string& line : lines) items += fmt::format("<li class=\"mono\">{}</li>\n", escape(line));
  return fmt::format("<h2>What is wrong with the kernels</h2>\n<ul>\n{}</ul>\n", items);
}

}  // namespace warpgrain::reports::html
