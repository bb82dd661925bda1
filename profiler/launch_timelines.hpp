#pragma once
// Follows the warps of a launch that timeline.hpp's options ask for. Which those are shows only when all have
// run, so that candidates are written down as they come: few, since the rest of a warp is counted already.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "profiler/kernel_graph.hpp"
#include "profiler/launch.hpp"
#include "profiler/merge_policy.hpp"
#include "profiler/observers/timeline_observer.hpp"
#include "profiler/timeline.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler {

class WarpMerger;

class LaunchTimelines {
 public:
  // Sees the warps of one thread of the program.
  class Recorder {
   public:
    explicit Recorder(LaunchTimelines& launch);
    ~Recorder();

    // `lanes` are the traces of warp `warp` of work-group `group`, `sums` what it counted.
    void warp_done(std::uint64_t group, std::size_t warp, std::span<const LaneTrace> lanes,
                   const WarpSums& sums);

   private:
    friend class LaunchTimelines;
    struct Merging;
    // The warp with the highest value so far; of equal ones the lowest number, whatever the threads.
    struct Highest {
      double value = 0;
      std::optional<WarpTimeline> timeline;
      bool beaten_by(double other, std::uint64_t warp) const;
    };
    WarpTimeline recorded(std::uint64_t warp, std::span<const LaneTrace> lanes);
    void keep_if_highest(Highest& highest, double value, std::uint64_t warp,
                         std::span<const LaneTrace> lanes);

    LaunchTimelines* launch_;
    std::unique_ptr<Merging> merging_;  // made when the first warp is written down
    std::map<std::uint64_t, WarpTimeline> asked_,
        spread_;  // by number; those among which the median is sought
    Highest worst_, costliest_;
  };

  // `graph` outlives it.
  LaunchTimelines(const KernelGraph& graph, const LaunchShape& shape, MergePolicy policy,
                  std::uint32_t warp_width, TimelineOptions options);

  // One for each thread of the program. Not to be called side by side.
  Recorder& new_recorder();

  // When every warp has been seen: the sums of all by number, and the timelines, the most telling first.
  const std::vector<WarpSums>& sums() const { return sums_; }
  std::vector<WarpTimeline> timelines() const;

 private:
  double efficiency(const WarpSums& sums) const;
  const WarpTimeline* nearest_to_median(const std::map<std::uint64_t, WarpTimeline>& candidates) const;

  const KernelGraph& graph_;
  MergePolicy policy_;
  std::uint32_t warp_width_;
  TimelineOptions options_;
  std::uint64_t warps_a_group_;
  std::vector<WarpSums> sums_;
  std::vector<std::uint64_t> spread_;  // numbers of warps that lie evenly in the launch, ascending
  std::vector<std::unique_ptr<Recorder>> recorders_;
};

}  // namespace warpgrain::profiler
