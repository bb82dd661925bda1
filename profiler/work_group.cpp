#include "profiler/work_group.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

#include "core/error.hpp"
#include "profiler/launch_check.hpp"

namespace warpgrain::profiler {
namespace {

// Frames of translated code and of the C library's functions below it.
constexpr std::size_t base_stack_bytes = std::size_t{64} << 10;

std::string name_of(const std::array<std::uint64_t, 3>& group) {
  return fmt::format("work-group ({}, {}, {})", group[0], group[1], group[2]);
}

}  // namespace

GroupRunner::GroupRunner(const TranslatedKernel& kernel, const LaunchShape& shape,
                         std::span<const KernelArgument> arguments)
    : kernel_(kernel), shape_(shape), lanes_(shape.work_group_size()), traces_(shape.work_group_size()) {
  lay_out_parameters(arguments);
  for (std::size_t i = 0; i < lanes_.size(); ++i) place_lane(i);
  // Behind the limits there is room for one pass over every block, as the loop checks need it.
  const KernelGraph& graph = kernel.graph;
  std::size_t accesses = 0;
  for (const BasicBlock& block : graph.blocks) accesses += block.accesses.size();
  if (kernel.mode != TraceMode::none)
    blocks_.emplace(lanes_.size(), (max_recorded + graph.blocks.size() + 1) * sizeof(BlockIndex));
  if (kernel.mode == TraceMode::blocks_and_addresses)
    addresses_.emplace(lanes_.size(), (max_recorded + accesses) * sizeof(std::uint64_t));
  if (graph.has_barrier || graph.has_warp_level)
    scheduler_.emplace(kernel, lanes_.size(), base_stack_bytes + kernel.local_bytes);
}

void GroupRunner::lay_out_parameters(std::span<const KernelArgument> arguments) {
  const std::vector<std::size_t> offsets = shared_offsets(kernel_, arguments);
  shared_.emplace(offsets.back());

  parameters_.resize(kernel_.parameter_bytes);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (kernel_.parameters[i].bytes == 0) continue;  // no parameter: memory that the kernel names itself
    const KernelArgument& argument = arguments[i];
    std::byte* const place = parameters_.data() + kernel_.parameter_offsets[i];
    if (argument.kind == KernelArgument::Kind::scalar) {
      std::memcpy(place, argument.value.data(), argument.value.size());
      continue;
    }
    const std::byte* pointer = argument.memory.empty() ? nullptr : argument.memory.data();
    if (argument.kind == KernelArgument::Kind::local) pointer = shared_->bytes().data() + offsets[i];
    std::memcpy(place, &pointer, sizeof pointer);
  }
}

void GroupRunner::place_lane(std::size_t index) {
  LaneContext& lane = lanes_[index];
  lane.parameters = parameters_.data();
  lane.shared = shared_->bytes().data();
  lane.printed = &printed_;
  lane.shared_bytes = static_cast<std::uint32_t>(shared_->bytes().size());
  const auto linear = static_cast<std::uint32_t>(index);
  const auto& local = shape_.local_size;
  lane.tid[0] = linear % local[0];
  lane.tid[1] = linear / local[0] % local[1];
  lane.tid[2] = linear / local[0] / local[1];
  const auto groups = shape_.group_count();
  for (std::size_t d = 0; d < 3; ++d) {
    lane.ntid[d] = local[d];
    lane.nctaid[d] = static_cast<std::uint32_t>(groups[d]);
  }
  lane.linear_tid = linear;
  lane.work_group_size = static_cast<std::uint32_t>(lanes_.size());
}

void GroupRunner::prepare_lane(std::size_t index, const std::array<std::uint64_t, 3>& group) {
  LaneContext& lane = lanes_[index];
  if (blocks_) {
    lane.trace = reinterpret_cast<BlockIndex*>(blocks_->lane(index));
    lane.trace_limit = lane.trace + max_recorded;
    traces_[index].blocks = lane.trace;
  }
  if (addresses_) {
    lane.addresses = reinterpret_cast<std::uint64_t*>(addresses_->lane(index));
    lane.addresses_limit = lane.addresses + max_recorded;
    traces_[index].addresses = lane.addresses;
  }
  lane.status = LaneStatus::done;
  lane.clock = 0;
  for (std::size_t d = 0; d < 3; ++d) lane.ctaid[d] = static_cast<std::uint32_t>(group[d]);
}

std::span<const LaneTrace> GroupRunner::run(const std::array<std::uint64_t, 3>& group) {
  release_long_traces();
  std::ranges::fill(shared_->bytes(), std::byte{0});
  for (std::size_t i = 0; i < lanes_.size(); ++i) prepare_lane(i, group);
  if (scheduler_) {
    if (const LaneContext* stopped = scheduler_->run(lanes_, name_of(group))) refuse_status(*stopped, group);
  } else {
    for (LaneContext& lane : lanes_) {
      kernel_.lane(&lane);
      if (lane.status != LaneStatus::done) refuse_status(lane, group);
    }
  }
  return traces_;
}

void GroupRunner::refuse_status(const LaneContext& lane, const std::array<std::uint64_t, 3>& group) const {
  const std::string where =
      fmt::format("{}, {}, work-item {}", kernel_.place(), name_of(group), lane.linear_tid);
  const std::string source = kernel_.source_of(lane.line);
  if (lane.status == LaneStatus::trapped)
    throw_input_error(where, fmt::format("it ran the trap at {}", source), "an end");
  if (lane.status == LaneStatus::no_function)
    throw_input_error(where, fmt::format("it called through a pointer at {} to no function", source),
                      "the address of a function that fits the call and is not running");
  if (lane.status == LaneStatus::endless_loop)
    throw_input_error(where, fmt::format("it entered the loop at {}, which nothing leaves", source),
                      "an end");
  throw_input_error(where, fmt::format("its trace is full in the loop at {}", source),
                    fmt::format("an end within {} recorded blocks or memory accesses", max_recorded));
}

void GroupRunner::release_long_traces() {
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    if (blocks_ && lanes_[i].trace)
      blocks_->release(
          i, static_cast<std::size_t>(reinterpret_cast<std::byte*>(lanes_[i].trace) - blocks_->lane(i)));
    if (addresses_ && lanes_[i].addresses)
      addresses_->release(i, static_cast<std::size_t>(reinterpret_cast<std::byte*>(lanes_[i].addresses) -
                                                      addresses_->lane(i)));
  }
}

}  // namespace warpgrain::profiler
