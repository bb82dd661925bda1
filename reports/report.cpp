#include "reports/report.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "reports/number_text.hpp"

namespace warpgrain::reports {

namespace {

constexpr std::string_view limit_of_ptx =
    "Instructions are those of the PTX. A GPU runs SASS, which ptxas makes of it: against an H100, PTX "
    "counts of "
    "warp instructions were 14 to 25 % low and SIMT efficiency lay between 1 % below and 13 % above.";
constexpr std::string_view limit_of_sass =
    "Instructions are those of the machine code that ptxas makes; a driver's own assembler may be of another "
    "version. Blocks and what-if answers are those of the PTX.";

std::string weights_of(std::span<const profiler::LaunchProfile> launches) {
  const auto of_sass = std::ranges::count_if(
      launches, [](const profiler::LaunchProfile& launch) { return launch.counters.weights.sass; });
  if (of_sass == 0) return "ptx";
  return static_cast<std::size_t>(of_sass) == launches.size() ? "sass" : "mixed";
}

}  // namespace

std::vector<std::string> simulator_limits() {
  return {
      "The lanes of a warp run one after another, so kernels in which lanes of a warp wait for each other "
      "(spin locks) "
      "are not carried.",
      "Caches are not modelled: sectors are those that warps ask for, not those that reach memory.",
      "Lanes that part come together at the join that the compiler is expected to mark. The scheduling of "
      "Volta and "
      "later at joins without such a mark is not modelled.",
  };
}

namespace {

std::uint64_t bytes_of_buffers(std::span<const profiler::LaunchProfile> launches) {
  std::vector<profiler::BufferExtent> buffers;
  for (const profiler::LaunchProfile& launch : launches)
    buffers.insert(buffers.end(), launch.counters.buffers.begin(), launch.counters.buffers.end());
  std::ranges::sort(buffers, {}, &profiler::BufferExtent::address);
  std::uint64_t bytes = 0, end = 0;
  for (const profiler::BufferExtent& buffer : buffers) {
    const std::uint64_t begin = std::max(buffer.address, end);
    end = std::max(end, buffer.address + buffer.bytes);
    bytes += end - std::min(begin, end);
  }
  return bytes;
}

}  // namespace

std::optional<std::uint64_t> touched_together(
    std::initializer_list<std::span<const profiler::LaunchProfile>> launches) {
  profiler::TouchedMemory touched;
  for (const auto& some : launches)
    for (const profiler::LaunchProfile& launch : some) {
      if (!launch.counters.footprint) return std::nullopt;
      add(touched, launch.counters.touched);
    }
  return bytes_of(touched);
}

Report make_report(std::span<const profiler::LaunchProfile> launches, std::string command_line) {
  Report report;
  report.generator = this_generator();
  report.command_line = std::move(command_line);
  report.weights = weights_of(launches);
  report.buffer_bytes = bytes_of_buffers(launches);
  report.touched_bytes = touched_together({launches});
  report.limits = simulator_limits();
  if (report.weights != "sass") report.limits.insert(report.limits.begin(), std::string(limit_of_ptx));
  if (report.weights != "ptx") report.limits.insert(report.limits.begin(), std::string(limit_of_sass));
  for (const profiler::LaunchProfile& launch : launches)
    report.launches.push_back({launch.counters,
                               {.name = launch.source_name,
                                .text = launch.source,
                                .hash = text_hash(launch.source),
                                .compiler = launch.compiler,
                                .command = launch.compile_command},
                               {text_hash(launch.ptx), {}}});
  return report;
}

std::string title_of(const Report& report) {
  std::vector<std::string> parts;
  if (report.scene) parts.push_back(*report.scene);
  if (report.variant) parts.push_back(*report.variant);
  if (report.particles) parts.push_back(count_text(*report.particles) + " particles");
  if (report.step) parts.push_back("step " + count_text(*report.step));
  if (parts.empty())
    for (const LaunchReport& launch : report.launches)
      if (std::find(parts.begin(), parts.end(), launch.counters.kernel) == parts.end())
        parts.push_back(launch.counters.kernel);
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace warpgrain::reports
