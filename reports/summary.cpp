#include "reports/summary.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <tuple>
#include <utility>

#include "reports/predicted_times.hpp"

namespace warpgrain::reports {
namespace {

using profiler::BranchTotals;
using profiler::LaunchCounters;
using profiler::LineTotals;

void add_lines(std::vector<LineTotals>& sum, const std::vector<LineTotals>& more) {
  std::map<std::pair<std::string, std::uint32_t>, std::size_t> place;
  for (std::size_t k = 0; k < sum.size(); ++k) place[{sum[k].file, sum[k].line}] = k;
  for (const LineTotals& line : more) {
    const auto [found, is_new] = place.try_emplace({line.file, line.line}, sum.size());
    if (is_new)
      sum.push_back(line);
    else
      sum[found->second].totals.add(line.totals);
  }
  std::sort(sum.begin(), sum.end(), [](const LineTotals& a, const LineTotals& b) {
    return std::tie(a.file, a.line) < std::tie(b.file, b.line);
  });
}

void add_branches(std::vector<BranchTotals>& sum, const std::vector<BranchTotals>& more) {
  for (const BranchTotals& branch : more) {
    const auto same =
        std::find_if(sum.begin(), sum.end(), [&](const BranchTotals& b) { return b.block == branch.block; });
    if (same == sum.end()) {
      sum.push_back(branch);
      continue;
    }
    same->executions += branch.executions;
    same->divergent += branch.divergent;
    same->lanes += branch.lanes;
    same->taken_lanes += branch.taken_lanes;
    same->lane_slots_lost += branch.lane_slots_lost;
  }
  std::stable_sort(sum.begin(), sum.end(), [](const BranchTotals& a, const BranchTotals& b) {
    return a.lane_slots_lost > b.lane_slots_lost;
  });
}

void add_blocks(std::vector<profiler::BlockTotals>& sum, const std::vector<profiler::BlockTotals>& more) {
  for (std::size_t b = 0; b < sum.size() && b < more.size(); ++b) {
    sum[b].executions += more[b].executions;
    sum[b].divergent += more[b].divergent;
    for (std::size_t k = 0; k < sum[b].lane_histogram.size() && k < more[b].lane_histogram.size(); ++k)
      sum[b].lane_histogram[k] += more[b].lane_histogram[k];
  }
}

// Launches of one kernel answer the same questions.
void add_answers(std::vector<profiler::WhatIfTotals>& sum, const std::vector<profiler::WhatIfTotals>& more) {
  for (const profiler::WhatIfTotals& answer : more) {
    const auto same = std::find_if(sum.begin(), sum.end(), [&](const profiler::WhatIfTotals& s) {
      return s.warp_width == answer.warp_width && s.policy == answer.policy && s.order == answer.order &&
             s.pool == answer.pool;
    });
    if (same == sum.end()) {
      sum.push_back(answer);
    } else {
      same->warps += answer.warps;
      same->totals.add(answer.totals);
    }
  }
}

void add(LaunchCounters& sum, const LaunchCounters& more) {
  sum.warps += more.warps;
  sum.totals.add(more.totals);
  sum.lane_slots_never_used += more.lane_slots_never_used;
  add_lines(sum.lines, more.lines);
  add_branches(sum.branches, more.branches);
  add_blocks(sum.blocks, more.blocks);
  add_answers(sum.what_if, more.what_if);
}

void add(std::optional<PredictedTime>& sum, const std::optional<PredictedTime>& more) {
  if (!sum || !more) return sum.reset();
  for (double PredictedTime::*part :
       {&PredictedTime::start, &PredictedTime::issue, &PredictedTime::sfu, &PredictedTime::lines,
        &PredictedTime::memory, &PredictedTime::latency, &PredictedTime::seconds})
    *sum.*part += *more.*part;
}

double ratio(double numerator, double denominator) { return denominator == 0 ? 0 : numerator / denominator; }

}  // namespace

std::optional<double> sectors_per_request(const profiler::MemoryCounters& access) {
  return access.requests == 0 ? std::nullopt : std::optional(access.sectors_per_request());
}

std::string policy_text(const profiler::WhatIfTotals& answer) {
  return answer.pool == 0 ? answer.policy : fmt::format("bound, pools of {}", answer.pool);
}

std::vector<std::string> remarks_of(const std::vector<profiler::WhatIfTotals>& answers) {
  std::vector<std::string> remarks;
  for (const profiler::WhatIfTotals& answer : answers)
    if (!answer.remark.empty() && std::find(remarks.begin(), remarks.end(), answer.remark) == remarks.end())
      remarks.push_back(answer.remark);
  return remarks;
}

std::uint64_t KernelSummary::lane_slots_lost() const {
  return counters.totals.lane_slots_idle(counters.warp_width);
}

std::vector<KernelSummary> kernels_of(const Report& report) {
  std::vector<KernelSummary> kernels;
  for (const LaunchReport& launch : report.launches) {
    const LaunchCounters& counters = launch.counters;
    const auto same = std::find_if(kernels.begin(), kernels.end(), [&](const KernelSummary& k) {
      return k.counters.kernel == counters.kernel && k.source->hash == launch.source.hash &&
             k.counters.warp_width == counters.warp_width && k.counters.policy == counters.policy;
    });
    if (same == kernels.end()) {
      kernels.push_back({1, counters, &launch.source, predicted_time(report, launch)});
    } else {
      ++same->launches;
      add(same->counters, counters);
      add(same->predicted, predicted_time(report, launch));
    }
  }
  std::stable_sort(kernels.begin(), kernels.end(), [](const KernelSummary& a, const KernelSummary& b) {
    return a.counters.totals.warp_instructions > b.counters.totals.warp_instructions;
  });
  return kernels;
}

Headline headline_of(const LaunchCounters& counters) {
  return headline_of({KernelSummary{1, counters, nullptr, std::nullopt}});
}

Headline headline_of(const Report& report) {
  Headline headline = headline_of(kernels_of(report));
  if (headline.predicted_seconds && report.list_making)
    *headline.predicted_seconds += report.list_making->predicted_seconds_a_step();
  return headline;
}

Headline headline_of(const std::vector<KernelSummary>& kernels) {
  Headline sum;
  profiler::MemoryCounters loads;
  double lane_slots = 0;
  for (const KernelSummary& kernel : kernels) {
    const profiler::Totals& totals = kernel.counters.totals;
    sum.warp_instructions += totals.warp_instructions;
    sum.thread_instructions += totals.thread_instructions;
    sum.branches += totals.branches;
    sum.divergent_branches += totals.divergent_branches;
    sum.sfu_instructions += totals.sfu_instructions;
    loads.requests += totals.global_load.requests;
    loads.sectors += totals.global_load.sectors;
    lane_slots += static_cast<double>(totals.warp_instructions) * kernel.counters.warp_width;
    if (kernel.predicted)
      sum.predicted_seconds = sum.predicted_seconds.value_or(0) + kernel.predicted->seconds;
  }
  const auto lanes = static_cast<double>(sum.thread_instructions);
  sum.active_lanes = ratio(lanes, static_cast<double>(sum.warp_instructions));
  sum.simt_efficiency = ratio(lanes, lane_slots);
  sum.sectors_per_load = sectors_per_request(loads);
  const auto heaviest = std::max_element(kernels.begin(), kernels.end(), [](const auto& a, const auto& b) {
    return a.counters.totals.warp_instructions < b.counters.totals.warp_instructions;
  });
  if (heaviest != kernels.end()) {
    const profiler::LaunchCounters& counters = heaviest->counters;
    sum.heaviest_kernel = {counters.kernel,
                           ratio(static_cast<double>(counters.totals.warp_instructions),
                                 static_cast<double>(sum.warp_instructions)),
                           counters.totals.simt_efficiency(counters.warp_width)};
  }
  return sum;
}

}  // namespace warpgrain::reports
