#include "profiler/partings.hpp"

#include <algorithm>

namespace warpgrain::profiler {

Partings::Node Partings::make(Node parent, std::uint32_t branch, std::uint64_t missing,
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

void Partings::release(Node node) {
  while (node != none) {
    Entry& entry = nodes_[node];
    if (--entry.references != 0) return;
    lost_[entry.branch] += entry.instructions * static_cast<std::uint64_t>(std::popcount(entry.missing));
    if (entry.parent != none) nodes_[entry.parent].instructions += entry.instructions;
    free_.push_back(node);
    node = entry.parent;
  }
}

Partings::Node Partings::join(Node a, Node b, std::uint64_t lanes) {
  Node common_a = a, common_b = b;
  std::uint64_t parted = 0;  // from a, since a and b were one group
  while (common_a != common_b) {
    if (nodes_[common_a].depth >= nodes_[common_b].depth) {
      parted |= nodes_[common_a].missing;
      common_a = nodes_[common_a].parent;
    } else {
      common_b = nodes_[common_b].parent;
    }
  }
  const std::uint64_t rest = parted & ~lanes;
  ++nodes_[common_a].references;
  const Node joined = rest == 0 ? common_a : join_rest(a, b, common_a, rest);
  release(a);
  release(b);
  return joined;
}

// Lanes of `rest` were parted from both; of the two partings the later counts.
Partings::Node Partings::join_rest(Node a, Node b, Node common, std::uint64_t rest) {
  struct Parting {
    std::uint64_t number, missing;
    std::uint32_t branch;
  };
  std::vector<Parting> partings;
  for (Node node : {a, b})
    for (; node != common; node = nodes_[node].parent)
      if ((nodes_[node].missing & rest) != 0)
        partings.push_back({nodes_[node].parting, nodes_[node].missing & rest, nodes_[node].branch});
  std::sort(partings.begin(), partings.end(),
            [](const auto& x, const auto& y) { return x.number > y.number; });
  Node joined = common;
  for (const Parting& parting : partings) {
    const std::uint64_t missing = parting.missing & rest;
    if (missing == 0) continue;
    rest &= ~missing;
    joined = make(joined, parting.branch, missing, parting.number);
  }
  return joined;
}

}  // namespace warpgrain::profiler
