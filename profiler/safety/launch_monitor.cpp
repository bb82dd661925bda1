#include "profiler/safety/launch_monitor.hpp"

namespace warpgrain::profiler {

LaunchMonitor::LaunchMonitor(const TranslatedKernel& kernel, const LaunchShape& shape,
                             std::span<const KernelArgument> arguments, const RunLimits& limits)
    : kernel_(kernel),
      shape_(shape),
      arguments_(arguments),
      limits_(limits),
      memory_(kernel, shape, arguments, limits.concurrent) {}

std::uint64_t LaunchMonitor::number_of(const std::array<std::uint64_t, 3>& group) const {
  const auto groups = shape_.group_count();
  return group[0] + groups[0] * (group[1] + groups[1] * group[2]);
}

std::array<std::uint64_t, 3> LaunchMonitor::global_id(std::uint64_t item) const {
  Diagnostic of_item;
  set_item(of_item, item);
  return of_item.work_item;
}

void LaunchMonitor::set_item(Diagnostic& diagnostic, std::uint64_t item) const {
  const auto groups = shape_.group_count();
  std::uint64_t group = item / shape_.work_group_size(), local = item % shape_.work_group_size();
  for (std::size_t d = 0; d < 3; ++d) {
    diagnostic.work_group[d] = group % groups[d];
    group /= groups[d];
  }
  const auto local_size = shape_.local_size_of(diagnostic.work_group);
  for (std::size_t d = 0; d < 3; ++d) {
    diagnostic.work_item[d] = diagnostic.work_group[d] * shape_.local_size[d] + local % local_size[d];
    local /= local_size[d];
  }
}

std::vector<Diagnostic> LaunchMonitor::diagnostics() const {
  const std::lock_guard lock(mutex_);
  std::vector<Diagnostic> all;
  for (const auto& [key, entry] : found_) {
    all.push_back(entry.diagnostic);
    all.back().count = entry.count;
  }
  return all;
}

}  // namespace warpgrain::profiler
