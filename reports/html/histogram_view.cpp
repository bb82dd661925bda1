#include <algorithm>
#include <fmt/format.h>

#include "reports/html/views.hpp"
#include "reports/number_text.hpp"

namespace warpgrain::reports::html {
namespace {

// Pixels of the drawing; the page scales it.
constexpr double width = 760, height = 190, left = 54, top = 10, bottom = 34;
constexpr double plot_width = width - left - 6, plot_height = height - top - bottom;

std::string grid_line(double share, double largest) {
  const double y = top + plot_height * (1 - share / largest);
  return fmt::format(
      "<line x1=\"{0}\" y1=\"{1:.1f}\" x2=\"{2}\" y2=\"{1:.1f}\"/><text x=\"{3}\" y=\"{4:.1f}\" "
      "text-anchor=\"end\">{5:.1f} %</text>\n",
      left, y, width - 6, left - 6, y + 4, 100 * share);
}

}  // namespace

std::string histogram_view(const profiler::LaunchCounters& counters) {
  const std::vector<std::uint64_t>& bins = counters.totals.lane_histogram;
  const auto all = static_cast<double>(counters.totals.warp_instructions);
  const auto most = bins.empty() ? 0 : *std::max_element(bins.begin(), bins.end());
  if (most == 0) return "<p class=\"soft\">No instruction was issued.</p>\n";
  const double largest = static_cast<double>(most) / all;

  std::string html = fmt::format(
      "<h3>Warp instructions by number of active lanes</h3>\n<svg class=\"histogram\" viewBox=\"0 0 {} {}\" "
      "role=\"img\" "
      "aria-label=\"Histogram of active lanes\">\n",
      width, height);
  for (const double part : {0.0, 0.5, 1.0}) html += grid_line(part * largest, largest);
  const double pitch = plot_width / static_cast<double>(bins.size());
  const std::size_t tick = std::max<std::size_t>(1, counters.warp_width / 8);
  for (std::size_t lanes = 0; lanes < bins.size(); ++lanes) {
    const double share = static_cast<double>(bins[lanes]) / all,
                 x = left + pitch * static_cast<double>(lanes);
    const double bar = plot_height * share / largest;
    html += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"><title>{} active lanes: {} warp "
        "instructions, {}</title></rect>\n",
        x + 0.1 * pitch, top + plot_height - bar, 0.8 * pitch, bar, lanes, count_text(bins[lanes]),
        percent_text(share, 1));
    if (lanes % tick == 0)
      html += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", x + pitch / 2,
                          top + plot_height + 15, lanes);
  }
  html += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">active lanes of {}</text>\n",
                      left + plot_width / 2, height - 4, counters.warp_width);
  return html + "</svg>\n";
}

}  // namespace warpgrain::reports::html
