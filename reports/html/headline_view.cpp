#include <fmt/format.h>

#include "reports/html/page.hpp"
#include "reports/html/views.hpp"
#include "reports/metrics.hpp"
#include "reports/number_text.hpp"

namespace warpgrain::reports::html {
namespace {

std::string tile(const char* key, const std::string& value, const std::string& remark = {}) {
  const Metric& m = metric(key);
  return fmt::format(
      "<div class=\"tile\"><div class=\"label\">{}</div><div class=\"value\">{}</div><div "
      "class=\"note\">{}{}{}</div></div>\n",
      escape(m.label), escape(value), remark.empty() ? "" : escape(remark) + "<br/>", escape(m.definition),
      m.ncu_metric.empty() ? "" : fmt::format("<br/><code>{}</code>", escape(m.ncu_metric)));
}

std::string share(std::uint64_t part, std::uint64_t whole, const char* of) {
  return fmt::format("{} of {}", percent_text(static_cast<double>(part), static_cast<double>(whole)), of);
}

}  // namespace

std::string headline_view(const std::vector<KernelSummary>& kernels) {
  const Headline headline = headline_of(kernels);
  std::string html = "<div class=\"tiles\">\n";
  html += tile("simt_efficiency", fixed_text(headline.simt_efficiency, 3));
  html += tile("active_lanes", fixed_text(headline.active_lanes, 2));
  html += tile("warp_instructions", count_text(headline.warp_instructions));
  html += tile("divergent_branches", count_text(headline.divergent_branches),
               share(headline.divergent_branches, headline.branches, "the branches"));
  html += tile("sfu_instructions", count_text(headline.sfu_instructions),
               share(headline.sfu_instructions, headline.warp_instructions, "the warp instructions"));
  html +=
      tile("sectors_per_load", headline.sectors_per_load ? fixed_text(*headline.sectors_per_load, 2) : "-");
  return html + "</div>\n";
}

}  // namespace warpgrain::reports::html
