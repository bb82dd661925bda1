#include "reports/html/page_scripts.hpp"

#include <fmt/format.h>

#include "reports/html/charts.hpp"
#include "reports/html/page.hpp"

namespace warpgrain::reports::html {
namespace {

// Text that stands between CDATA's marks for readers of XML. What ends them stands in strings of the library,
// where it can be written in another way, and in comparisons, which a blank does not change.
std::string script_of(std::string_view text, std::string_view attributes = "") {
  std::string script(text);
  for (std::size_t at = 0; (at = script.find("]]>", at)) != std::string::npos; at += 3)
    if (at > 0 && script[at - 1] == '"')
      script.replace(at + 2, 1, "\\x3e");
    else
      script.insert(at + 2, " ");
  return fmt::format("<script{}>//<![CDATA[\n{}\n//]]></script>\n", attributes, script);
}

bool has(std::string_view body, std::string_view mark) { return body.find(mark) != std::string_view::npos; }

}  // namespace

std::string page_scripts(std::string_view body) {
  std::string scripts;
  if (!echarts_script().empty() && (has(body, "<div class=\"chart\"") || has(body, "data-lanes="))) {
    scripts += script_of(echarts_script(), " type=\"text/plain\" id=\"chart_library\"");  // charts.js runs it
    for (const char* file : {"charts", "plain_charts", "sweep_charts", "profile_charts", "start_charts"})
      scripts += script_of(asset(fmt::format("html/{}.js", file)));
  }
  if (has(body, "data-timeline=")) scripts += script_of(asset("html/timeline.js"));
  if (has(body, "data-bed=")) scripts += script_of(asset("html/bed.js"));
  return scripts.empty() ? scripts : script_of(asset("html/tools.js")) + scripts;
}

}  // namespace warpgrain::reports::html
