#include "reports/state_sample.hpp"

#include <algorithm>
#include <functional>

namespace warpgrain::reports {

std::uint64_t StateSample::warp_instructions() const {
  std::uint64_t all = 0;
  for (const Kernel& kernel : kernels) all += kernel.warp_instructions;
  return all;
}

double StateSample::simt_efficiency() const {
  double used = 0;  // warp instructions' worth of lanes
  for (const Kernel& kernel : kernels)
    used += kernel.simt_efficiency * static_cast<double>(kernel.warp_instructions);
  const std::uint64_t all = warp_instructions();
  return all == 0 ? 0 : used / static_cast<double>(all);
}

const StateSample::Kernel* StateSample::kernel_named(std::string_view name) const {
  const auto found = std::ranges::find(kernels, name, &Kernel::kernel);
  return found == kernels.end() ? nullptr : &*found;
}

std::vector<std::string> heavy_kernels(std::span<const StateSample> samples) {
  std::vector<std::string> names;
  for (const StateSample& sample : samples)
    for (const StateSample::Kernel& kernel : sample.kernels)
      if (kernel.warp_instructions * 100 >= sample.warp_instructions() &&
          std::ranges::find(names, kernel.kernel) == names.end())
        names.push_back(kernel.kernel);
  return names;
}

StateSample state_sample(std::uint64_t step, double time, const CandidateCensus& census,
                         std::span<const profiler::LaunchCounters> launches) {
  StateSample sample;
  sample.step = step;
  sample.time = time;
  sample.mean_candidates = census.mean_candidates;
  sample.most_candidates = census.most_candidates;
  sample.mean_contacts = census.mean_contacts;
  sample.most_contacts = census.most_contacts;
  struct Sum {
    std::string kernel;
    profiler::Totals totals;
  };
  std::vector<Sum> sums;
  for (const profiler::LaunchCounters& launch : launches) {
    const auto known = std::ranges::find(sums, launch.kernel, &Sum::kernel);
    if (known == sums.end())
      sums.push_back({launch.kernel, launch.totals});
    else
      known->totals.add(launch.totals);
  }
  std::ranges::stable_sort(sums, std::greater(), [](const Sum& sum) { return sum.totals.warp_instructions; });
  for (const Sum& sum : sums)
    sample.kernels.push_back(
        {sum.kernel, sum.totals.warp_instructions, sum.totals.simt_efficiency(launches.front().warp_width)});
  return sample;
}

}  // namespace warpgrain::reports
