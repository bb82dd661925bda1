#include "profiler/partings.hpp"

#include <algorithm>

namespace warpgrain::profiler {

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
  std::vector<Parting>& partings = scratch_;
  partings.clear();
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
