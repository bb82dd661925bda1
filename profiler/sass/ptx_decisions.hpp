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

// A trace names blocks r0 r1 r2 ...: each is where the decision at the end of the straight run of blocks from
// the one before it went. Decisions are numbered by the line of their instruction, so that copies of an
// inlined function are one.
class PtxDecisions {
 public:
  explicit PtxDecisions(const KernelGraph& graph);

  std::size_t count() const { return blocks_.size(); }
  // The blocks with that decision at their end, at least one.
  const std::vector<std::uint32_t>& blocks_of(std::uint32_t decision) const { return blocks_[decision]; }
  // The decision at the end of the block itself, or no_decision.
  std::uint32_t at_end_of(std::uint32_t block) const { return at_end_[block]; }
  // The block with a decision that the straight run from `block` comes to, itself included; no_block where the
  // lane ends first.
  std::uint32_t run_end(std::uint32_t block) const { return run_end_[block]; }
  // The block that must have gone before `block` and decided to go there, over a straight run; no_block where
  // there is no single one.
  std::uint32_t decided_by(std::uint32_t block) const { return decided_by_[block]; }
  // Calls f for every block of the straight run from `block`.
  template <class F>
  void for_run(std::uint32_t block, F&& f) const {
    for (std::size_t guard = 0; guard <= graph_.blocks.size(); ++guard) {
      f(block);
      if (graph_.blocks[block].successors.size() != 1) return;
      block = graph_.blocks[block].successors[0];
    }
  }
  // Instructions with a line of the PTX; empty for lines that have none.
  const std::vector<PtxPlace>& places(std::uint32_t line) const;
  const KernelGraph& graph() const { return graph_; }

 private:
  const KernelGraph& graph_;
  std::vector<std::vector<std::uint32_t>> blocks_;
  std::vector<std::uint32_t> at_end_, run_end_, decided_by_;
  std::unordered_map<std::uint32_t, std::vector<PtxPlace>> places_;
};

}  // namespace warpgrain::profiler::sass
