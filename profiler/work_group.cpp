#include "profiler/work_group.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <limits>

#include "profiler/launch_check.hpp"

namespace warpgrain::profiler {
namespace {

// Frames of the C library's functions below translated code.
constexpr std::size_t base_stack_bytes = std::size_t{64} << 10;

std::string_view end_text(LaneStatus status) {
  switch (status) {
    case LaneStatus::trapped:
      return "it ran the trap";
    case LaneStatus::no_function:
      return "it called through a pointer to no function that fits the call and is not running";
    case LaneStatus::endless_loop:
      return "it entered a loop that nothing leaves";
    case LaneStatus::trace_exhausted:
      return "its trace is full; it was stopped and is not counted";
    case LaneStatus::budget_exhausted:
      return "it ran all instructions that it may; it was stopped and is not counted";
    case LaneStatus::done:
      break;
  }
  return {};
}

DiagnosticKind kind_of(LaneStatus status) {
  return status == LaneStatus::trapped           ? DiagnosticKind::trap
         : status == LaneStatus::no_function     ? DiagnosticKind::invalid_call
         : status == LaneStatus::endless_loop    ? DiagnosticKind::endless_loop
         : status == LaneStatus::trace_exhausted ? DiagnosticKind::trace_limit
                                                 : DiagnosticKind::instruction_limit;
}

}  // namespace

GroupRunner::GroupRunner(LaunchMonitor& monitor)
    : monitor_(monitor),
      kernel_(monitor.kernel()),
      shape_(monitor.shape()),
      all_lanes_(shape_.work_group_size()),
      lanes_(all_lanes_),
      traces_(shape_.work_group_size()) {
  const std::vector<std::size_t> shared_offsets = profiler::shared_offsets(kernel_, monitor.arguments());
  shared_.emplace(shared_offsets.back());
  lay_out_parameters(shared_offsets);
  if (kernel_.checks == Checks::on) checker_.emplace(monitor, parameters_, shared_->bytes(), shared_offsets);
  // Behind the limits there is room for one pass over every block, as the loop checks need it.
  const KernelGraph& graph = kernel_.graph;
  std::size_t accesses = 0;
  for (const BasicBlock& block : graph.blocks) accesses += block.accesses.size();
  if (kernel_.mode != TraceMode::none)
    blocks_.emplace(lanes_.size(), (max_recorded + graph.blocks.size() + 1) * sizeof(BlockIndex));
  if (kernel_.mode == TraceMode::blocks_and_addresses)
    addresses_.emplace(lanes_.size(), (max_recorded + accesses) * sizeof(std::uint64_t));
  const bool in_turns = graph.has_barrier || graph.has_warp_level;
  if (kernel_.local_bytes > 0) local_.emplace(in_turns ? lanes_.size() : 1, kernel_.local_bytes);
  if (in_turns) scheduler_.emplace(kernel_, lanes_.size(), base_stack_bytes + kernel_.frame_bytes);
  place_lanes(shape_.local_size);
}

void GroupRunner::lay_out_parameters(std::span<const std::size_t> shared_offsets) {
  parameters_.resize(kernel_.parameter_bytes);
  const std::span<const KernelArgument> arguments = monitor_.arguments();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (kernel_.parameters[i].bytes == 0) continue;  // no parameter: memory that the kernel names itself
    const KernelArgument& argument = arguments[i];
    std::byte* const place = parameters_.data() + kernel_.parameter_offsets[i];
    if (argument.kind == KernelArgument::Kind::scalar) {
      std::memcpy(place, argument.value.data(), argument.value.size());
      continue;
    }
    const std::byte* pointer = argument.memory.empty() ? nullptr : argument.memory.data();
    if (argument.kind == KernelArgument::Kind::local) pointer = shared_->bytes().data() + shared_offsets[i];
    std::memcpy(place, &pointer, sizeof pointer);
  }
}

void GroupRunner::place_lanes(const std::array<std::uint32_t, 3>& local_size) {
  local_size_ = local_size;
  lanes_ = std::span(all_lanes_).first(std::size_t{local_size[0]} * local_size[1] * local_size[2]);
  for (std::size_t i = 0; i < lanes_.size(); ++i) place_lane(i);
}

void GroupRunner::place_lane(std::size_t index) {
  LaneContext& lane = lanes_[index];
  lane.parameters = parameters_.data();
  lane.shared = shared_->bytes().data();
  lane.printed = &printed_;
  lane.shared_bytes = static_cast<std::uint32_t>(shared_->bytes().size());
  if (local_) lane.local = local_->lane(scheduler_ ? index : 0);
  if (checker_) checker_->place(lane);
  const auto linear = static_cast<std::uint32_t>(index);
  lane.tid[0] = linear % local_size_[0];
  lane.tid[1] = linear / local_size_[0] % local_size_[1];
  lane.tid[2] = linear / local_size_[0] / local_size_[1];
  const auto groups = shape_.group_count();
  for (std::size_t d = 0; d < 3; ++d) {
    lane.ntid[d] = shape_.local_size[d];
    lane.nctaid[d] = static_cast<std::uint32_t>(groups[d]);
    lane.global_size[d] = static_cast<std::uint32_t>(shape_.global_size[d]);
  }
  lane.linear_tid = linear;
  lane.work_group_size = static_cast<std::uint32_t>(lanes_.size());
}

void GroupRunner::prepare_lane(std::size_t index, const std::array<std::uint64_t, 3>& group) {
  LaneContext& lane = lanes_[index];
  if (blocks_) {
    lane.trace = reinterpret_cast<BlockIndex*>(blocks_->lane(index));
    traces_[index].blocks = lane.trace;
  }
  if (addresses_) {
    lane.addresses = reinterpret_cast<std::uint64_t*>(addresses_->lane(index));
    traces_[index].addresses = lane.addresses;
  }
  lane.status = LaneStatus::done;
  lane.clock = 0;
  lane.budget = static_cast<std::int64_t>(
      std::min<std::uint64_t>(monitor_.limits().max_instructions, std::numeric_limits<std::int64_t>::max()));
  for (std::size_t d = 0; d < 3; ++d) lane.ctaid[d] = static_cast<std::uint32_t>(group[d]);
}

// Lanes that run to their end one after another share what there is; those that run in turns have equal
// parts.
void GroupRunner::limit_traces(std::size_t index) {
  LaneContext& lane = lanes_[index];
  const auto entries = [&](std::size_t used, std::size_t entry_bytes) {
    const std::size_t bytes =
        scheduler_ ? max_trace_bytes / lanes_.size() : max_trace_bytes - std::min(used, max_trace_bytes);
    return std::min(max_recorded, bytes / entry_bytes);
  };
  if (blocks_) lane.trace_limit = lane.trace + entries(blocks_used_, sizeof(BlockIndex));
  if (addresses_) lane.addresses_limit = lane.addresses + entries(addresses_used_, sizeof(std::uint64_t));
}

std::span<const LaneTrace> GroupRunner::run(const std::array<std::uint64_t, 3>& group) {
  release_long_traces();
  std::ranges::fill(shared_->bytes(), std::byte{0});
  const std::uint64_t number = monitor_.number_of(group);
  first_item_ = number * all_lanes_.size();
  if (const auto local_size = shape_.local_size_of(group); local_size != local_size_) place_lanes(local_size);
  if (checker_) checker_->begin_group(number);
  for (std::size_t i = 0; i < lanes_.size(); ++i) prepare_lane(i, group);
  blocks_used_ = addresses_used_ = 0;
  if (scheduler_) {
    run_in_turns();
  } else {
    run_lanes();
  }
  return std::span(traces_).first(lanes_.size());
}

void GroupRunner::run_lanes() {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    if (monitor_.given_up()) {
      traces_[i].blocks = nullptr;
      continue;
    }
    limit_traces(i);
    if (local_) std::memset(lanes_[i].local, 0, kernel_.local_bytes);
    kernel_.lane(&lanes_[i]);
    lane_ended(i);
  }
}

void GroupRunner::run_in_turns() {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    limit_traces(i);
    if (local_) std::memset(lanes_[i].local, 0, kernel_.local_bytes);
    traces_[i].blocks = nullptr;  // until it has ended
  }
  scheduler_->run(lanes_, *this);
}

void GroupRunner::lane_ended(std::size_t index) {
  const LaneContext& lane = lanes_[index];
  if (blocks_)
    blocks_used_ += static_cast<std::size_t>(reinterpret_cast<std::byte*>(lane.trace) - blocks_->lane(index));
  if (addresses_)
    addresses_used_ +=
        static_cast<std::size_t>(reinterpret_cast<std::byte*>(lane.addresses) - addresses_->lane(index));
  if (blocks_) traces_[index].blocks = reinterpret_cast<BlockIndex*>(blocks_->lane(index));
  if (lane.status == LaneStatus::done) return;
  const auto loop = std::find_if(kernel_.loops.begin(), kernel_.loops.end(),
                                 [&](const LoopFacts& facts) { return facts.line == lane.line; });
  const bool waits =
      loop != kernel_.loops.end() && loop->waits_for_memory && lane.status != LaneStatus::trapped;
  monitor_.note(kind_of(lane.status), lane.line, AccessSite::any_object, first_item_ + index,
                [&](Diagnostic& d) {
                  d.detail = end_text(lane.status);
                  if (waits)
                    d.detail +=
                        "; the loop waits for memory that another work-item would have to write; "
                        "lanes run one after another";
                });
  if (lane.status == LaneStatus::trapped) return;
  monitor_.note_stopped();
  traces_[index].blocks = nullptr;
}

void GroupRunner::lanes_met(std::span<const std::size_t> lanes, bool of_warp) {
  if (checker_) checker_->lanes_met(lanes, of_warp);
}

void GroupRunner::lanes_stuck(std::size_t index, const std::string& who) {
  monitor_.note(DiagnosticKind::barrier_divergence, lanes_[index].line, AccessSite::any_object,
                first_item_ + index, [&](Diagnostic& d) { d.detail = who; });
}

void GroupRunner::release_long_traces() {
  for (std::size_t i = 0; i < all_lanes_.size(); ++i) {
    if (blocks_ && all_lanes_[i].trace)
      blocks_->release(
          i, static_cast<std::size_t>(reinterpret_cast<std::byte*>(all_lanes_[i].trace) - blocks_->lane(i)));
    if (addresses_ && all_lanes_[i].addresses)
      addresses_->release(i, static_cast<std::size_t>(reinterpret_cast<std::byte*>(all_lanes_[i].addresses) -
                                                      addresses_->lane(i)));
  }
}

}  // namespace warpgrain::profiler
