#pragma once
// The control flow of a program, from the definitions: a node dominates another when there is no way around
// it. Slow, plain, and nothing of the simulator's.

#include <cstdint>
#include <optional>
#include <vector>

#include "tests/profiler/oracle/program.hpp"

namespace warpgrain::oracle {

using Node = std::uint32_t;

// Instructions without a way in but the first or a way out but the last.
struct Stretch {
  Place first = 0, last = 0;  // [first, last)
  std::vector<Node> to;       // where lanes go: the number of stretches stands for their end
};

struct Loop {
  Node header = 0;
  std::vector<bool> inside;  // [stretches]: the header, and what leads back to it without passing it
  std::size_t size = 0;
};

class Flow {
 public:
  explicit Flow(const Program& program);

  const std::vector<Stretch>& stretches() const { return stretches_; }
  const std::vector<Loop>& loops() const { return loops_; }
  Node end() const { return static_cast<Node>(stretches_.size()); }

  // For each stretch the nearest that lanes from it cannot avoid before they end; end() where there is none.
  // With a loop: among its stretches alone, ways out of it left aside and an iteration's end taken for the
  // end.
  std::vector<Node> nearest_post_dominators(const Loop* level) const;

  // All stretches that lanes can reach, in reverse post-order of a depth-first search that follows `to` in
  // order, each loop in one piece: outside of it, it is one node, with its ways out in the order of the text.
  std::vector<Node> loop_contiguous_order() const;

 private:
  void cut(const Program& program);
  void find_loops();
  std::vector<bool> reached(const std::vector<std::vector<Node>>& edges, Node from,
                            std::optional<Node> without) const;
  void append_level(const Loop* level, std::vector<Node>& order) const;
  // The outermost loop strictly inside `level` that holds the node.
  const Loop* loop_within(const Loop* level, Node node) const;

  std::vector<Stretch> stretches_;
  std::vector<Loop> loops_;
};

}  // namespace warpgrain::oracle
