#include "reports/predicted_times.hpp"

#include <fmt/format.h>

#include "reports/number_text.hpp"
#include "reports/text_table.hpp"

namespace warpgrain::reports {

std::optional<PredictedTime> predicted_time(const Report& report, const LaunchReport& launch) {
  if (!report.machine) return std::nullopt;
  // Before a launch that stands alone whole buffers are written; the launches of a step meet again what the
  // step before has touched.
  const std::uint64_t working_set =
      report.scene ? report.touched_bytes.value_or(report.buffer_bytes) : report.buffer_bytes;
  return predict_time(launch.counters, *report.machine, static_cast<double>(working_set),
                      report.scene ? LaunchPlace::next : LaunchPlace::alone);
}

std::string predicted_table(const Report& report, const std::vector<KernelSummary>& kernels) {
  TextTable table({{"kernel", TextTable::Align::left},
                   {"predicted"},
                   {"start"},
                   {"issue"},
                   {"SFU"},
                   {"cache lines"},
                   {"memory"},
                   {"latency"},
                   {"resident warps"}});
  double all = 0;
  for (const KernelSummary& kernel : kernels) {
    if (!kernel.predicted) return {};
    const PredictedTime& time = *kernel.predicted;
    all += time.seconds;
    table.add_row({kernel.counters.kernel, seconds_text(time.seconds), seconds_text(time.start),
                   seconds_text(time.issue), seconds_text(time.sfu), seconds_text(time.lines),
                   seconds_text(time.memory), seconds_text(time.latency),
                   fixed_text(time.resident_warps, 0)});
  }
  if (kernels.empty()) return {};
  return fmt::format("\n{}: predicted time {}, and what each part would take alone\n{}", report.machine->name,
                     seconds_text(all), table.text());
}

}  // namespace warpgrain::reports
