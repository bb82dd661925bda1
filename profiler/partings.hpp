#pragma once
// Which branch keeps which lanes out of each group of a warp, at a cost per parting and joining, not per
// instruction.
//
// A lane that is not in the running group was parted from it by one branch: the one at which the lane, or a
// lane that it ran with, last went another way than the group. When groups join, the later of their partings
// from a lane counts.
//
// A group's partings are a path to the root of a tree: a node says that `branch` parted the lanes `missing`
// from the group, its parent says what was so before. Instructions are added to the group's node; when no
// group is left below a node, they are multiplied by the missing lanes, added to the branch, and passed on to
// the parent.

#include <bit>
#include <cstdint>
#include <vector>

namespace warpgrain::profiler {

class Partings {
 public:
  using Node = std::uint32_t;

  // `lost`, [n_branches], receives lane slots by branch number.
  explicit Partings(std::vector<std::uint64_t>& lost) : lost_(lost) {}

  // The node of a warp's first group; `missing` lanes are there never, for which the number `branch` stands.
  Node root(std::uint32_t branch, std::uint64_t missing) { return make(none, branch, missing, 0); }

  // Counts instructions that the group with this node issued.
  void issue(Node node, std::uint64_t instructions) { nodes_[node].instructions += instructions; }

  // The parts of one parting share `parting`, a number that grows with time. Each part has its own node below
  // the group's, which is then released.
  Node part(Node group, std::uint32_t branch, std::uint64_t missing, std::uint64_t parting) {
    ++nodes_[group].references;
    return make(group, branch, missing, parting);
  }

  // The node of two groups that become one; takes the place of both. `lanes` are those of the new group.
  Node join(Node a, Node b, std::uint64_t lanes);

  // No group has the node any more.
  void release(Node node);

 private:
  static constexpr Node none = 0xFFFFFFFF;
  struct Entry {
    Node parent = none;
    std::uint32_t references = 0;  // groups and children
    std::uint32_t branch = 0;
    std::uint32_t depth = 0;
    std::uint64_t missing = 0;
    std::uint64_t parting = 0;
    std::uint64_t instructions = 0;
  };

  struct Parting {
    std::uint64_t number, missing;
    std::uint32_t branch;
  };

  Node make(Node parent, std::uint32_t branch, std::uint64_t missing, std::uint64_t parting);
  Node join_rest(Node a, Node b, Node common, std::uint64_t rest);

  std::vector<std::uint64_t>& lost_;
  std::vector<Entry> nodes_;
  std::vector<Node> free_;
  std::vector<Parting> scratch_;  // of join_rest
};

// These are for every group of every warp; here so that callers compiled for a processor count bits with its
// instruction.
inline Partings::Node Partings::make(Node parent, std::uint32_t branch, std::uint64_t missing,
                                     std::uint64_t parting) {
  Node node;
  if (free_.empty()) {
    node = static_cast<Node>(nodes_.size());
    nodes_.emplace_back();
  } else {
    node = free_.back();
    free_.pop_back();
  }
  const std::uint32_t depth = parent == none ? 0 : nodes_[parent].depth + 1;
  nodes_[node] = {parent, 1, branch, depth, missing, parting, 0};
  return node;
}

inline void Partings::release(Node node) {
  while (node != none) {
    Entry& entry = nodes_[node];
    if (--entry.references != 0) return;
    lost_[entry.branch] += entry.instructions * static_cast<std::uint64_t>(std::popcount(entry.missing));
    if (entry.parent != none) nodes_[entry.parent].instructions += entry.instructions;
    free_.push_back(node);
    node = entry.parent;
  }
}

}  // namespace warpgrain::profiler
