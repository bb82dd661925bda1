#include "profiler/profile.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <exception>
#include <fmt/format.h>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "core/error.hpp"
#include "profiler/merge.hpp"
#include "profiler/observers/blocks.hpp"
#include "profiler/observers/branches.hpp"
#include "profiler/observers/lines.hpp"
#include "profiler/observers/totals.hpp"
#include "profiler/observers/warp_counters.hpp"
#include "profiler/ordered_output.hpp"
#include "profiler/source_lines.hpp"

namespace warpgrain::profiler {
namespace {

constexpr std::uint64_t groups_a_chunk = 16;  // taken by a thread at a time

void check(const LaunchShape& shape, const ProfileOptions& options) {
  const std::uint32_t width = options.warp_width;
  if (width < min_warp_width || width > max_warp_width || !std::has_single_bit(width))
    throw_input_error("warp width", fmt::format("{}", width),
                      fmt::format("a power of two from {} to {}", min_warp_width, max_warp_width));
  for (std::size_t d = 0; d < 3; ++d)
    if (shape.global_size[d] == 0 || shape.local_size[d] == 0 ||
        shape.global_size[d] % shape.local_size[d] != 0)
      throw_input_error(
          fmt::format("launch, dimension {}", d),
          fmt::format("global size {}, local size {}", shape.global_size[d], shape.local_size[d]),
          "a global size that the local size divides");
}

// Runs the work-groups of one launch, on any number of threads at once.
class Launch {
 public:
  Launch(const Executable& executable, const LaunchShape& shape, std::span<const KernelArgument> arguments,
         const ProfileOptions& options)
      : executable_(executable),
        shape_(shape),
        arguments_(arguments),
        options_(options),
        groups_(shape.group_count()) {
    n_groups_ = groups_[0] * groups_[1] * groups_[2];
    if (options.printed != nullptr) printed_.emplace(*options.printed);
  }

  std::uint64_t n_groups() const { return n_groups_; }

  // Until no work-groups are left. One of the threads tells the progress.
  void run_groups(WarpMerger& merger, bool tells_progress) {
    try {
      const std::unique_ptr<WorkGroupRunner> runner = executable_.runner(shape_, arguments_);
      for (;;) {
        const std::uint64_t begin = next_group_.fetch_add(groups_a_chunk);
        if (begin >= n_groups_) return;
        const std::uint64_t end = std::min(begin + groups_a_chunk, n_groups_);
        for (std::uint64_t group = begin; group < end; ++group) run_group(*runner, group, merger);
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
  void run_group(WorkGroupRunner& runner, std::uint64_t group, WarpMerger& merger) {
    try {
      merge_group(runner, group, merger);
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

  void merge_group(WorkGroupRunner& runner, std::uint64_t group, WarpMerger& merger) const {
    std::span<const LaneTrace> lanes =
        runner.run({group % groups_[0], group / groups_[0] % groups_[1], group / groups_[0] / groups_[1]});
    while (!lanes.empty()) {
      const std::size_t n = std::min<std::size_t>(options_.warp_width, lanes.size());
      merger.merge(lanes.first(n));
      lanes = lanes.subspan(n);
    }
  }

  const Executable& executable_;
  const LaunchShape& shape_;
  std::span<const KernelArgument> arguments_;
  const ProfileOptions& options_;
  std::array<std::uint64_t, 3> groups_;
  std::uint64_t n_groups_;
  std::atomic<std::uint64_t> next_group_ = 0;
  std::optional<OrderedOutput> printed_;
  std::mutex error_mutex_;
  std::exception_ptr error_;
};

WarpCounters run_observed(const KernelGraph& graph, Launch& launch, const ProfileOptions& options) {
  WarpCounters counters(graph, options.warp_width);
  WarpCounterObserver counting(graph, counters);
  ObserverPair both(counting, *options.observer);
  launch.run_groups(*make_observed_merger(graph, options.policy, options.warp_width, both), true);
  launch.rethrow_error();
  return counters;
}

WarpCounters run_counted(const KernelGraph& graph, Launch& launch, const ProfileOptions& options) {
  const std::uint64_t wanted =
      options.threads != 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
  const std::uint64_t useful = (launch.n_groups() + groups_a_chunk - 1) / groups_a_chunk;
  std::vector<WarpCounters> of_threads(std::min(wanted, useful), WarpCounters(graph, options.warp_width));
  const auto work = [&](std::size_t thread) {
    launch.run_groups(*make_counting_merger(graph, options.policy, of_threads[thread]), thread == 0);
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t thread = 1; thread < of_threads.size(); ++thread) threads.emplace_back(work, thread);
    work(0);
  }
  launch.rethrow_error();
  for (std::size_t thread = 1; thread < of_threads.size(); ++thread) of_threads[0].add(of_threads[thread]);
  return std::move(of_threads[0]);
}

}  // namespace

LaunchCounters profile_launch(const Executable& executable, const LaunchShape& shape,
                              std::span<const KernelArgument> arguments, std::string_view source,
                              const ProfileOptions& options) {
  check(shape, options);
  const KernelGraph& graph = executable.graph();
  Launch launch(executable, shape, arguments, options);
  const WarpCounters counters = options.observer != nullptr ? run_observed(graph, launch, options)
                                                            : run_counted(graph, launch, options);
  LaunchCounters result;
  result.kernel = graph.kernel;
  result.shape = shape;
  result.warp_width = options.warp_width;
  result.policy = merge_policy_name(options.policy);
  result.warps = counters.warps;
  result.totals = launch_totals(graph, counters);
  result.lines = line_totals(graph, counters);
  result.blocks = block_totals(graph, counters);
  result.branches = branch_totals(graph, counters, SourceLines(source, options.source_name));
  result.lane_slots_never_used = counters.lane_slots_lost[counters.never_used()];
  return result;
}

}  // namespace warpgrain::profiler
