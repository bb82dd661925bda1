#include "profiler/observers/path_census.hpp"

#include <algorithm>
#include <bit>

namespace warpgrain::profiler {

void PathCensus::launch_begins(const KernelGraph& graph) {
  end_all();
  const auto known = std::ranges::find(kernels_, graph.kernel, &Kernel::name);
  current_ = static_cast<std::size_t>(known - kernels_.begin());
  if (known != kernels_.end()) return;
  const ControlFlow flow(graph);
  const auto outside = static_cast<std::uint32_t>(flow.loops().size());
  Kernel kernel;
  kernel.name = graph.kernel;
  kernel.bodies.resize(outside + 1);
  for (const Loop& loop : flow.loops()) {
    kernel.parent.push_back(loop.parent == no_loop ? outside : loop.parent);
    kernel.header.push_back(loop.header);
  }
  kernel.parent.push_back(outside);
  kernel.header.push_back(no_block);  // nothing leads to the entry again
  for (Body& body : kernel.bodies) body.facts.kernel = graph.kernel;
  kernel.bodies[outside].facts.is_loop = false;
  for (std::size_t b = 0; b < graph.blocks.size(); ++b) {
    const BasicBlock& block = graph.blocks[b];
    const std::uint32_t loop = flow.loop_of()[b];
    kernel.loop_of.push_back(loop == no_loop ? outside : loop);
    kernel.instructions.push_back(static_cast<std::uint32_t>(block.instructions.size()));
    LoopPaths& facts = kernel.bodies[kernel.loop_of.back()].facts;
    facts.branches += block.successors.size() > 1 ? 1 : 0;
    for (const Instruction& instruction : block.instructions)
      if (facts.line == 0 && instruction.location.line != 0) {
        facts.line = instruction.location.line;
        facts.file = graph.files[instruction.location.file];
      }
  }
  kernels_.push_back(std::move(kernel));
}

void PathCensus::end_pass(Body& body, std::size_t lane) {
  if (body.hash[lane] == 0) return;
  ++body.facts.passes;
  ++body.passes_of[body.hash[lane]];
  body.hash[lane] = 0;
}

void PathCensus::end_all() {
  if (current_ >= kernels_.size()) return;
  for (Body& body : kernels_[current_].bodies)
    for (std::size_t lane = 0; lane < max_lanes; ++lane) end_pass(body, lane);
}

void PathCensus::warp_begins(std::uint64_t) {
  end_all();
  std::ranges::fill(body_of_lane_, static_cast<std::uint32_t>(kernels_[current_].bodies.size() - 1));
}

void PathCensus::block_issued(const LaneGroup& group, std::span<const std::uint64_t* const>) {
  Kernel& kernel = kernels_[current_];
  const std::uint32_t to = kernel.loop_of[group.block];
  for (std::uint64_t left = group.lanes; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    std::uint32_t& at = body_of_lane_[lane];
    // Out of loops that do not hold the block.
    const auto holds = [&](std::uint32_t body) {
      for (std::uint32_t inner = to;; inner = kernel.parent[inner]) {
        if (inner == body) return true;
        if (kernel.parent[inner] == inner) return false;
      }
    };
    for (; !holds(at); at = kernel.parent[at]) end_pass(kernel.bodies[at], lane);
    at = to;
    Body& body = kernel.bodies[to];
    if (group.block == kernel.header[to]) end_pass(body, lane);
    std::uint64_t& hash = body.hash[lane];
    hash = (hash ^ (group.block + 1)) * 0x9E3779B97F4A7C15U;  // 2^64 / golden ratio
    hash ^= hash >> 29;
    if (hash == 0) hash = 1;
    body.facts.instructions += kernel.instructions[group.block];
  }
}

std::vector<LoopPaths> PathCensus::bodies() {
  end_all();
  std::vector<LoopPaths> all;
  for (const Kernel& kernel : kernels_)
    for (const Body& body : kernel.bodies) {
      if (body.facts.passes == 0) continue;
      all.push_back(body.facts);
      all.back().paths = body.passes_of.size();
    }
  return all;
}

}  // namespace warpgrain::profiler
