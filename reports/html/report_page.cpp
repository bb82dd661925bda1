#include "reports/html/report_page.hpp"

#include <fmt/format.h>

#include "reports/html/page.hpp"
#include "reports/html/samples_view.hpp"
#include "reports/html/views.hpp"
#include "reports/number_text.hpp"
#include "reports/summary.hpp"

namespace warpgrain::reports {
namespace {

std::string kernel_section(const KernelSummary& kernel, std::uint64_t all_instructions, bool open) {
  const profiler::LaunchCounters& counters = kernel.counters;
  const Headline headline = headline_of(counters);
  return fmt::format(
      "<details{}><summary><span class=\"mono\">{}</span> <span class=\"soft\">{} of the warp instructions, "
      "SIMT "
      "efficiency {}</span></summary>\n{}{}{}{}</details>\n",
      open ? " open=\"\"" : "", html::escape(counters.kernel),
      percent_text(static_cast<double>(counters.totals.warp_instructions),
                   static_cast<double>(all_instructions)),
      fixed_text(headline.simt_efficiency, 3), html::histogram_view(counters), html::branches_view(kernel),
      html::timeline_view(kernel) + html::what_if_view(kernel) + html::source_view(kernel) +
          html::blocks_view(kernel),
      html::instruction_mix_view(counters.totals));
}

}  // namespace

std::string report_page(const Report& report) {
  const std::vector<KernelSummary> kernels = kernels_of(report);
  const std::string title = title_of(report);
  std::string body = fmt::format(
      "<h1>{}</h1>\n<p class=\"soft\">SIMT divergence report</p>\n{}{}", html::escape(title),
      html::diagnostics_view(report) + html::headline_view(kernels), html::kernels_view(report, kernels));
  if (report.list_making)
    body += fmt::format("<p>The search's {}.</p>\n", html::escape(text_of(*report.list_making)));
  body += html::machine_view(report, kernels);
  body += html::model_view(report.model);
  body += html::bed_view(report) + html::samples_view(report.samples);
  body += "<h2>Kernel by kernel</h2>\n";
  const std::uint64_t all_instructions = headline_of(kernels).warp_instructions;
  for (const KernelSummary& kernel : kernels)
    body += kernel_section(kernel, all_instructions, &kernel == &kernels.front());
  body += html::provenance_view(report);
  return html::page(title, body);
}

}  // namespace warpgrain::reports
