#pragma once
// The decisions that a lane's trace holds, in the terms that machine code is matched with.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "profiler/kernel_graph.hpp"

namespace warpgrain::profiler::sass {

inline constexpr std::uint32_t no_decision = 0xFFFFFFFF;

// An instruction of the graph. Where calls were put in place, several have the same line of the PTX.
struct PtxPlace {
  std::uint32_t block = 0, instruction = 0;
};

// A trace names the recorded blocks; the others follow on the straight run from one of them. What comes
// behind a run that ends in a decision is where it went. Decisions are numbered by the line of their
// instruction, so that copies of an inlined function are one.
class PtxDecisions {
 public:
  explicit PtxDecisions(const KernelGraph& graph);

  std::size_t count() const { return blocks_.size(); }
  // The blocks with that decision at their end, at least one.
  const std::vector<std::uint32_t>& blocks_of(std::uint32_t decision) const { return blocks_[decision]; }
  // The decision at the end of the block itself, or no_decision.
  std::uint32_t at_end_of(std::uint32_t block) const { return at_end_[block]; }
  // The block with a decision that the straight way from `block` comes to, itself included; no_block where
  // the lane ends first.
  std::uint32_t way_end(std::uint32_t block) const { return way_end_[block]; }
  // The block that must have gone before `block` and decided to go there, over a straight way; no_block where
  // there is no single one.
  std::uint32_t decided_by(std::uint32_t block) const { return decided_by_[block]; }
  // Calls f for every block that the entry `block` of a trace stands for.
  template <class F>
  void for_run(std::uint32_t block, F&& f) const {
    for (std::size_t steps = 0; steps <= graph_.blocks.size(); ++steps) {
      f(block);
      const std::vector<std::uint32_t>& to = graph_.blocks[block].successors;
      if (to.size() != 1 || graph_.blocks[to[0]].recorded) return;
      block = to[0];
    }
  }
  // Instructions with a line of the PTX; empty for lines that have none.
  const std::vector<PtxPlace>& places(std::uint32_t line) const;
  const KernelGraph& graph() const { return graph_; }

 private:
  const KernelGraph& graph_;
  std::vector<std::vector<std::uint32_t>> blocks_;
  std::vector<std::uint32_t> at_end_, way_end_, decided_by_;
  std::unordered_map<std::uint32_t, std::vector<PtxPlace>> places_;
};

}  // namespace warpgrain::profiler::sass
