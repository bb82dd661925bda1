#include "profiler/profile.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <fmt/format.h>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "profiler/launch_timelines.hpp"
#include "profiler/merge.hpp"
#include "profiler/observers/blocks.hpp"
#include "profiler/observers/branches.hpp"
#include "profiler/observers/footprint.hpp"
#include "profiler/observers/lines.hpp"
#include "profiler/observers/totals.hpp"
#include "profiler/observers/warp_counters.hpp"
#include "profiler/ordered_output.hpp"
#include "profiler/safety/launch_monitor.hpp"
#include "profiler/sass/launch_replay.hpp"
#include "profiler/source_lines.hpp"
#include "profiler/what_if_run.hpp"

namespace warpgrain::profiler {
namespace {

constexpr std::uint64_t smallest_chunk = 16;  // work-groups taken by a thread at a time

void check(const LaunchShape& shape, const ProfileOptions& options) {
  check_warp_width(options.warp_width);
  for (std::size_t d = 0; d < 3; ++d)
    if (shape.global_size[d] == 0 || shape.local_size[d] == 0)
      throw_input_error(
          fmt::format("launch, dimension {}", d),
          fmt::format("global size {}, local size {}", shape.global_size[d], shape.local_size[d]),
          "sizes above 0");
}

unsigned n_threads(const ProfileOptions& options) {
  return options.threads != 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
}

// What else sees the work-groups of a launch.
struct Others {
  LaunchTimelines& timelines;
  WhatIfRun* what_if = nullptr;
  LaunchFootprint* footprint = nullptr;

  // For one thread of the program.
  std::vector<GroupVisitor*> new_visitors() const {
    std::vector<GroupVisitor*> visitors;
    if (what_if != nullptr) visitors.push_back(&what_if->new_visitor());
    if (footprint != nullptr) visitors.push_back(&footprint->new_visitor());
    return visitors;
  }
};

// Merges the warps of each work-group, replays them where that is asked for, and shows the group to the other
// visitors.
class MergingVisitor : public GroupVisitor {
 public:
  // `counters` is what the merger adds to.
  MergingVisitor(WarpMerger& merger, const WarpCounters& counters, LaunchTimelines::Recorder& timelines,
                 sass::WarpReplayer* replayer, std::vector<GroupVisitor*> others)
      : merger_(merger),
        counters_(counters),
        timelines_(timelines),
        replayer_(replayer),
        others_(std::move(others)) {}
  void visit(std::uint64_t group, std::span<const LaneTrace> lanes) override {
    const std::size_t width = counters_.warp_width;
    for (std::size_t first = 0; first < lanes.size(); first += width) {
      const auto warp = lanes.subspan(first, std::min(width, lanes.size() - first));
      const WarpSums before = counters_.issued;
      merger_.merge(warp);
      timelines_.warp_done(group, first / width, warp,
                           {counters_.issued.warp_instructions - before.warp_instructions,
                            counters_.issued.thread_instructions - before.thread_instructions});
      if (replayer_ != nullptr) replayer_->replay(warp);
    }
    for (GroupVisitor* other : others_) other->visit(group, lanes);
  }

 private:
  WarpMerger& merger_;
  const WarpCounters& counters_;
  LaunchTimelines::Recorder& timelines_;
  sass::WarpReplayer* replayer_;
  std::vector<GroupVisitor*> others_;
};

// Runs the work-groups of one launch, on any number of threads at once.
class Launch {
 public:
  Launch(const Executable& executable, const LaunchShape& shape, std::span<const KernelArgument> arguments,
         const ProfileOptions& options, std::uint64_t chunk_unit)
      : executable_(executable),
        options_(options),
        groups_(shape.group_count()),
        groups_a_chunk_((smallest_chunk + chunk_unit - 1) / chunk_unit * chunk_unit),
        monitor_(executable.monitor(shape, arguments,
                                    {.max_instructions = options.max_instructions,
                                     .concurrent = options.observer == nullptr && n_threads(options) > 1})) {
    n_groups_ = groups_[0] * groups_[1] * groups_[2];
    if (options.printed != nullptr) printed_.emplace(*options.printed);
  }

  std::uint64_t n_chunks() const { return (n_groups_ + groups_a_chunk_ - 1) / groups_a_chunk_; }
  const LaunchMonitor& monitor() const { return *monitor_; }

  // Until no work-groups are left. One of the threads tells the progress.
  void run_groups(GroupVisitor& visitor, bool tells_progress) {
    try {
      const std::unique_ptr<WorkGroupRunner> runner = executable_.runner(*monitor_);
      for (;;) {
        const std::uint64_t begin = next_group_.fetch_add(groups_a_chunk_);
        if (begin >= n_groups_ || monitor_->given_up()) return;
        const std::uint64_t end = std::min(begin + groups_a_chunk_, n_groups_);
        for (std::uint64_t group = begin; group < end; ++group) run_group(*runner, group, visitor);
        if (tells_progress && options_.progress)
          options_.progress(static_cast<double>(end) / static_cast<double>(n_groups_));
      }
    } catch (...) {
      next_group_ = n_groups_;  // the others need not go on
      const std::lock_guard lock(error_mutex_);
      if (!error_) error_ = std::current_exception();
    }
  }

  void rethrow_error() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  // What a group printed before it was stopped is kept, too.
  void run_group(WorkGroupRunner& runner, std::uint64_t group, GroupVisitor& visitor) {
    try {
      visitor.visit(group, runner.run({group % groups_[0], group / groups_[0] % groups_[1],
                                       group / groups_[0] / groups_[1]}));
    } catch (const InputError&) {
      write_printed(runner, group);
      throw;
    }
    write_printed(runner, group);
  }

  void write_printed(WorkGroupRunner& runner, std::uint64_t group) {
    std::string text = runner.take_printed();
    if (printed_) printed_->write(group, std::move(text));
  }

  const Executable& executable_;
  const ProfileOptions& options_;
  std::array<std::uint64_t, 3> groups_;
  std::uint64_t n_groups_;
  std::uint64_t groups_a_chunk_;
  std::unique_ptr<LaunchMonitor> monitor_;
  std::atomic<std::uint64_t> next_group_ = 0;
  std::optional<OrderedOutput> printed_;
  std::mutex error_mutex_;
  std::exception_ptr error_;
};

WarpCounters run_observed(const KernelGraph& graph, Launch& launch, const ProfileOptions& options,
                          const Others& others) {
  WarpCounters counters(graph, options.warp_width);
  WarpCounterObserver counting(graph, counters);
  ObserverPair both(counting, *options.observer);
  both.launch_begins(graph);
  const auto merger = make_observed_merger(graph, options.policy, options.warp_width, both);
  MergingVisitor visitor(*merger, counters, others.timelines.new_recorder(), nullptr, others.new_visitors());
  launch.run_groups(visitor, true);
  launch.rethrow_error();
  return counters;
}

WarpCounters run_counted(const KernelGraph& graph, Launch& launch, const ProfileOptions& options,
                         sass::LaunchReplay& replay, const Others& others) {
  struct Thread {
    WarpCounters counters;
    LaunchTimelines::Recorder& timelines;
    sass::WarpReplayer* replayer;
    std::vector<GroupVisitor*> others;
  };
  std::vector<Thread> of_threads;
  for (std::uint64_t thread = 0; thread < std::min<std::uint64_t>(n_threads(options), launch.n_chunks());
       ++thread)
    of_threads.push_back({WarpCounters(graph, options.warp_width), others.timelines.new_recorder(),
                          replay.new_replayer(), others.new_visitors()});
  const auto work = [&](std::size_t thread) {
    const Thread& mine = of_threads[thread];
    const auto merger = make_counting_merger(graph, options.policy, of_threads[thread].counters);
    MergingVisitor visitor(*merger, mine.counters, mine.timelines, mine.replayer, mine.others);
    launch.run_groups(visitor, thread == 0);
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t thread = 1; thread < of_threads.size(); ++thread) threads.emplace_back(work, thread);
    work(0);
  }
  launch.rethrow_error();
  for (std::size_t thread = 1; thread < of_threads.size(); ++thread)
    of_threads[0].counters.add(of_threads[thread].counters);
  return std::move(of_threads[0].counters);
}

}  // namespace

LaunchCounters profile_launch(const Executable& executable, const LaunchShape& shape,
                              std::span<const KernelArgument> arguments, std::string_view source,
                              const ProfileOptions& options) {
  check(shape, options);
  const KernelGraph& graph = executable.graph();
  const SourceLines source_lines(source, options.source_name);
  std::optional<WhatIfRun> what_if;
  if (!options.what_if.empty())
    what_if.emplace(graph, shape, source_lines,
                    WhatIfSetting{options.what_if, options.addresses, n_threads(options),
                                  options.trace_memory, options.skip_unknown_keys});
  Launch launch(executable, shape, arguments, options, what_if ? what_if->groups_a_chunk() : 1);
  sass::LaunchReplay replay(executable, options);
  std::optional<LaunchFootprint> footprint;
  if (options.footprint && options.addresses) footprint.emplace(graph, arguments);
  LaunchTimelines timelines(graph, shape, options.policy, options.warp_width, options.timelines);
  const Others others{timelines, what_if ? &*what_if : nullptr, footprint ? &*footprint : nullptr};
  const WarpCounters counters = options.observer != nullptr
                                    ? run_observed(graph, launch, options, others)
                                    : run_counted(graph, launch, options, replay, others);
  LaunchCounters result;
  result.kernel = graph.kernel;
  result.shape = shape;
  result.shared_bytes = graph.shared_bytes;
  for (const KernelArgument& argument : arguments) {
    result.shared_bytes += argument.local_bytes;
    if (!argument.memory.empty())
      result.buffers.push_back(
          {reinterpret_cast<std::uint64_t>(argument.memory.data()), argument.memory.size()});
  }
  result.warp_width = options.warp_width;
  result.policy = merge_policy_name(options.policy);
  result.warps = counters.warps;
  result.totals = launch_totals(graph, counters);
  if (footprint) {
    result.footprint = footprint->counters();
    result.touched = footprint->touched();
  }
  result.lines = line_totals(graph, counters);
  result.blocks = block_totals(graph, counters);
  result.branches = branch_totals(graph, counters, source_lines);
  result.lane_slots_never_used = counters.lane_slots_lost[counters.never_used()];
  replay.finish(source_lines, counters, result);
  if (what_if) result.what_if = what_if->answers();
  result.timelines = timelines.timelines();
  result.warp_sums = timelines.sums();
  result.diagnostics = launch.monitor().diagnostics();
  result.given_up = launch.monitor().given_up();
  return result;
}

}  // namespace warpgrain::profiler
