#include "reports/weights_text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "reports/number_text.hpp"

namespace warpgrain::reports {
namespace {

std::string line_of(const profiler::WeightsUsed& weights) {
  if (!weights.sass) return weights.reason.empty() ? "PTX" : fmt::format("PTX: {}", weights.reason);
  std::string line = fmt::format("SASS: {}, ptxas {}", weights.arch, weights.ptxas);
  if (weights.fast_paths != 0)
    line += fmt::format("; {} choices of lanes taken not to need routines for rare operands",
                        count_text(weights.fast_paths));
  if (weights.predicates_assumed != 0)
    line +=
        fmt::format("; predicates of {} thread instructions assumed", count_text(weights.predicates_assumed));
  if (weights.turns_assumed != 0)
    line +=
        fmt::format("; {} turns of groups of lanes after a YIELD assumed", count_text(weights.turns_assumed));
  if (weights.trips_assumed != 0)
    line +=
        fmt::format("; {} ways of lanes through unrolled loops assumed", count_text(weights.trips_assumed));
  if (weights.requests_of_ptx != 0)
    line += fmt::format("; requests of {} accesses are those of the PTX", weights.requests_of_ptx);
  return line;
}

}  // namespace

std::vector<std::string> weights_lines(const Report& report) {
  std::vector<std::pair<std::string, std::vector<std::string>>> lines;  // and the kernels that they hold for
  for (const LaunchReport& launch : report.launches) {
    const std::string line = line_of(launch.counters.weights);
    auto found = std::ranges::find(lines, line, &std::pair<std::string, std::vector<std::string>>::first);
    if (found == lines.end()) found = lines.insert(lines.end(), {line, {}});
    if (std::ranges::find(found->second, launch.counters.kernel) == found->second.end())
      found->second.push_back(launch.counters.kernel);
  }
  std::vector<std::string> result;
  for (const auto& [line, kernels] : lines)
    result.push_back(lines.size() == 1 ? line : fmt::format("{} ({})", line, fmt::join(kernels, ", ")));
  return result;
}

}  // namespace warpgrain::reports
