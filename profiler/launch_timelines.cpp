#include "profiler/launch_timelines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "profiler/merge.hpp"

namespace warpgrain::profiler {
namespace {

constexpr std::uint64_t n_spread = 32;

}  // namespace

// Merges a warp once more, slowly, with every event.
struct LaunchTimelines::Recorder::Merging {
  explicit Merging(const LaunchTimelines& launch)
      : observer(launch.graph_, launch.options_.max_executions),
        merger(make_observed_merger(launch.graph_, launch.policy_, launch.warp_width_, observer)) {}
  TimelineObserver observer;
  std::unique_ptr<WarpMerger> merger;
};

LaunchTimelines::Recorder::Recorder(LaunchTimelines& launch) : launch_(&launch) {}
LaunchTimelines::Recorder::~Recorder() = default;

bool LaunchTimelines::Recorder::Highest::beaten_by(double other, std::uint64_t warp) const {
  return !timeline || other > value || (other == value && warp < timeline->warp);
}

WarpTimeline LaunchTimelines::Recorder::recorded(std::uint64_t warp, std::span<const LaneTrace> lanes) {
  if (!merging_) merging_ = std::make_unique<Merging>(*launch_);
  merging_->merger->merge(lanes);
  WarpTimeline timeline = merging_->observer.timeline();
  timeline.warp = warp;
  return timeline;
}

void LaunchTimelines::Recorder::keep_if_highest(Highest& highest, double value, std::uint64_t warp,
                                                std::span<const LaneTrace> lanes) {
  if (!highest.beaten_by(value, warp)) return;
  highest.timeline = recorded(warp, lanes);
  highest.value = value;
}

void LaunchTimelines::Recorder::warp_done(std::uint64_t group, std::size_t warp_of_group,
                                          std::span<const LaneTrace> lanes, const WarpSums& sums) {
  const TimelineOptions& options = launch_->options_;
  const std::uint64_t warp = group * launch_->warps_a_group_ + warp_of_group;
  launch_->sums_[warp] = sums;
  if (sums.warp_instructions == 0) return;
  if (std::ranges::find(options.warps, warp) != options.warps.end()) asked_[warp] = recorded(warp, lanes);
  if (options.median && std::ranges::binary_search(launch_->spread_, warp))
    spread_[warp] = recorded(warp, lanes);
  if (options.worst) keep_if_highest(worst_, 1 - launch_->efficiency(sums), warp, lanes);
  if (options.costliest) {
    const std::uint64_t idle = launch_->warp_width_ * sums.warp_instructions - sums.thread_instructions;
    keep_if_highest(costliest_, static_cast<double>(idle), warp, lanes);
  }
}

LaunchTimelines::LaunchTimelines(const KernelGraph& graph, const LaunchShape& shape, MergePolicy policy,
                                 std::uint32_t warp_width, TimelineOptions options)
    : graph_(graph), policy_(policy), warp_width_(warp_width), options_(std::move(options)) {
  const auto groups = shape.group_count();
  const auto& local = shape.local_size;
  const std::uint64_t lanes_a_group = std::uint64_t{local[0]} * local[1] * local[2];
  warps_a_group_ = (lanes_a_group + warp_width - 1) / warp_width;
  sums_.resize(groups[0] * groups[1] * groups[2] * warps_a_group_);
  for (std::uint64_t k = 0; k < n_spread; ++k) spread_.push_back((2 * k + 1) * sums_.size() / (2 * n_spread));
}

LaunchTimelines::Recorder& LaunchTimelines::new_recorder() {
  return *recorders_.emplace_back(std::make_unique<Recorder>(*this));
}

double LaunchTimelines::efficiency(const WarpSums& sums) const {
  return static_cast<double>(sums.thread_instructions) / static_cast<double>(sums.warp_instructions) /
         warp_width_;
}

const WarpTimeline* LaunchTimelines::nearest_to_median(
    const std::map<std::uint64_t, WarpTimeline>& candidates) const {
  if (candidates.empty()) return nullptr;
  std::vector<double> all;
  for (const WarpSums& sums : sums_)
    if (sums.warp_instructions != 0) all.push_back(efficiency(sums));
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::ranges::nth_element(all, middle);
  const auto distance = [&](const auto& candidate) {
    return std::abs(efficiency(candidate.second.sums) - *middle);
  };
  return &std::ranges::min_element(candidates, {}, distance)->second;
}

std::vector<WarpTimeline> LaunchTimelines::timelines() const {
  std::map<std::uint64_t, WarpTimeline> asked, spread;
  Recorder::Highest worst, costliest;
  const auto keep_highest = [](Recorder::Highest& of_all, const Recorder::Highest& of_thread) {
    if (of_thread.timeline && of_all.beaten_by(of_thread.value, of_thread.timeline->warp)) of_all = of_thread;
  };
  for (const auto& recorder : recorders_) {
    asked.insert(recorder->asked_.begin(), recorder->asked_.end());
    spread.insert(recorder->spread_.begin(), recorder->spread_.end());
    keep_highest(worst, recorder->worst_);
    keep_highest(costliest, recorder->costliest_);
  }
  std::vector<WarpTimeline> timelines;
  const auto add = [&](const WarpTimeline& timeline, const char* chosen_as) {
    auto known = std::ranges::find(timelines, timeline.warp, &WarpTimeline::warp);
    if (known == timelines.end()) known = timelines.insert(known, timeline);
    known->chosen_as.emplace_back(chosen_as);
  };
  if (const WarpTimeline* median = nearest_to_median(spread)) add(*median, "median");
  if (worst.timeline) add(*worst.timeline, "worst");
  if (costliest.timeline) add(*costliest.timeline, "costliest");
  for (const auto& [warp, timeline] : asked) add(timeline, "number");
  return timelines;
}

}  // namespace warpgrain::profiler
