#include "reports/text_measured.hpp"

#include <fmt/format.h>

#include "analysis/statistics.hpp"
#include "reports/number_text.hpp"
#include "reports/text_table.hpp"

namespace warpgrain::reports {
namespace {

std::string spread_text(const Spread& spread) {
  return fmt::format("{:.1f} %", 100 * spread.relative_spread());
}

std::string agreement_text(const MeasuredReport::Kernel& kernel) {
  std::string text;
  for (const MeasuredReport::Agreement& a : kernel.agreement) {
    text += fmt::format("{} '{}': ", kernel.kernel, a.argument);
    text += a.differing == 0 ? fmt::format("the simulator's {} elements\n", count_text(a.elements))
                             : fmt::format(
                                   "{} of {} elements differ from the simulator's, by up to {:.3g} of the "
                                   "largest\n",
                                   count_text(a.differing), count_text(a.elements), a.largest_difference);
  }
  return text;
}

}  // namespace

std::string text_measured(const MeasuredReport& measured) {
  const MeasuredReport::Device& device = measured.device;
  std::string text = fmt::format("{}{}, driver {}\n", device.name,
                                 device.architecture.empty() ? "" : fmt::format(" ({})", device.architecture),
                                 device.driver);
  if (measured.scene)
    text += fmt::format("{}, {}, {} particles, {}\n", *measured.scene, measured.variant.value_or(""),
                        count_text(measured.particles.value_or(0)), measured.backend);
  if (measured.step) {
    const Spread spread = spread_of(measured.step->seconds);
    text += fmt::format("step: {}, spread {}, {} readings of {} steps", seconds_text(spread.median),
                        spread_text(spread), spread.readings, measured.step->steps);
    if (measured.particles)
      text += fmt::format("; {:.1f} million particle-steps/s",
                          1e-6 * static_cast<double>(*measured.particles) / spread.median);
    text += '\n';
  }
  TextTable table(
      {{"kernel", TextTable::Align::left}, {"calls"}, {"readings"}, {"median"}, {"spread"}, {"registers"}});
  for (const MeasuredReport::Kernel& kernel : measured.kernels) {
    const Spread spread = spread_of(kernel.seconds);
    table.add_row({kernel.kernel, count_text(kernel.calls), count_text(spread.readings),
                   seconds_text(spread.median), spread_text(spread),
                   kernel.code ? count_text(kernel.code->registers) : "-"});
  }
  text += table.text();
  for (const MeasuredReport::Kernel& kernel : measured.kernels) text += agreement_text(kernel);
  return text;
}

}  // namespace warpgrain::reports
