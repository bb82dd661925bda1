#pragma once
// What can be said about a kernel's control-flow graph alone: predecessors, dominators, natural loops, an
// order of the blocks that keeps loops together, and post-dominators of the whole graph or of one loop.
//
// Irreducible flow (a cycle entered at more than one block, which structured source does not give) is no
// error: such a cycle is no natural loop, so its blocks count to the loop around it, and the order breaks the
// cycle where the depth-first walk closed it.

#include <cstdint>
#include <span>
#include <vector>

#include "profiler/kernel_graph.hpp"

namespace warpgrain::profiler {

inline constexpr std::uint32_t no_block = 0xFFFFFFFF;
inline constexpr std::uint32_t no_loop = 0xFFFFFFFF;

// Successor lists, [n_blocks]; what the algorithms below need of a graph.
using SuccessorLists = std::vector<std::vector<std::uint32_t>>;

// Reverse post-order of the nodes that `root` reaches. Of two successors the later one comes first in the
// order.
std::vector<std::uint32_t> reverse_post_order(const SuccessorLists& successors, std::uint32_t root);

// Immediate dominators, [n_nodes]: root's is root itself, that of nodes it does not reach is no_block.
// Cooper, Harvey and Kennedy, "A Simple, Fast Dominance Algorithm" (2001).
std::vector<std::uint32_t> immediate_dominators(const SuccessorLists& successors, std::uint32_t root);

// A natural loop: a header and every block that gets back to it without leaving. Loops of one header are one
// loop.
struct Loop {
  std::uint32_t header = 0;
  std::uint32_t parent = no_loop;     // the next larger loop around this one
  std::vector<std::uint32_t> blocks;  // ascending, those of inner loops included
};

class ControlFlow {
 public:
  explicit ControlFlow(const KernelGraph& graph);

  const SuccessorLists& successors() const { return successors_; }
  const std::vector<Loop>& loops() const { return loops_; }  // outer before inner
  // The innermost loop of each block, or no_loop.
  std::span<const std::uint32_t> loop_of() const { return loop_of_; }

  // Every block once, a loop's blocks in one piece with the header first, and otherwise each block before
  // those that it leads to. Blocks that the entry does not reach come last.
  std::vector<std::uint32_t> loop_contiguous_order() const;

  // Immediate post-dominators, [n_blocks], of the graph that is left when only the blocks of `loop` count
  // (no_loop: all): edges back to its header and ends of the lane lead to a common exit, edges out of the
  // loop are dropped. no_block for the exit, for blocks outside, and for blocks that cannot get to the exit.
  std::vector<std::uint32_t> immediate_post_dominators(std::uint32_t loop) const;

 private:
  void find_loops();
  void append_level(std::uint32_t loop, std::vector<std::uint32_t>& order) const;
  bool contains(std::uint32_t loop, std::uint32_t block) const;

  SuccessorLists successors_;
  std::vector<Loop> loops_;
  std::vector<std::uint32_t> loop_of_;
};

}  // namespace warpgrain::profiler
