#include "profiler/control_flow.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace warpgrain::profiler {
namespace {

SuccessorLists reversed(const SuccessorLists& successors) {
  SuccessorLists result(successors.size());
  for (std::uint32_t from = 0; from < successors.size(); ++from)
    for (std::uint32_t to : successors[from]) result[to].push_back(from);
  return result;
}

}  // namespace

std::vector<std::uint32_t> reverse_post_order(const SuccessorLists& successors, std::uint32_t root) {
  std::vector<std::uint32_t> post;
  std::vector<bool> seen(successors.size());
  std::vector<std::pair<std::uint32_t, std::size_t>> path{{root, 0}};  // node, its next successor
  seen[root] = true;
  while (!path.empty()) {
    auto& [node, next] = path.back();
    if (next == successors[node].size()) {
      post.push_back(node);
      path.pop_back();
      continue;
    }
    const std::uint32_t to = successors[node][next++];
    if (!seen[to]) {
      seen[to] = true;
      path.emplace_back(to, 0);
    }
  }
  std::reverse(post.begin(), post.end());
  return post;
}

std::vector<std::uint32_t> immediate_dominators(const SuccessorLists& successors, std::uint32_t root) {
  const std::vector<std::uint32_t> order = reverse_post_order(successors, root);
  const SuccessorLists predecessors = reversed(successors);
  std::vector<std::uint32_t> rank(successors.size(), no_block);
  for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
  std::vector<std::uint32_t> dominator(successors.size(), no_block);
  dominator[root] = root;
  const auto common = [&](std::uint32_t a, std::uint32_t b) {
    while (a != b) {
      while (rank[a] > rank[b]) a = dominator[a];
      while (rank[b] > rank[a]) b = dominator[b];
    }
    return a;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 1; i < order.size(); ++i) {
      std::uint32_t nearest = no_block;
      for (std::uint32_t from : predecessors[order[i]])
        if (dominator[from] != no_block) nearest = nearest == no_block ? from : common(from, nearest);
      changed |= std::exchange(dominator[order[i]], nearest) != nearest;
    }
  }
  return dominator;
}

ControlFlow::ControlFlow(const KernelGraph& graph) : loop_of_(graph.blocks.size(), no_loop) {
  for (const BasicBlock& block : graph.blocks) successors_.push_back(block.successors);
  if (!successors_.empty()) find_loops();
}

bool ControlFlow::contains(std::uint32_t loop, std::uint32_t block) const {
  if (loop == no_loop) return true;
  return std::binary_search(loops_[loop].blocks.begin(), loops_[loop].blocks.end(), block);
}

void ControlFlow::find_loops() {
  const std::vector<std::uint32_t> dominator = immediate_dominators(successors_, 0);
  const SuccessorLists predecessors = reversed(successors_);
  const auto reached = [&](std::uint32_t block) { return dominator[block] != no_block; };
  const auto dominates = [&](std::uint32_t above, std::uint32_t block) {
    while (block != above && dominator[block] != block) block = dominator[block];
    return block == above;
  };
  for (std::uint32_t header = 0; header < successors_.size(); ++header) {
    if (!reached(header)) continue;
    std::vector<std::uint32_t> blocks, open;
    for (std::uint32_t from : predecessors[header])
      if (reached(from) && dominates(header, from)) open.push_back(from);
    if (open.empty()) continue;
    std::vector<bool> inside(successors_.size());
    inside[header] = true;
    blocks.push_back(header);
    while (!open.empty()) {
      const std::uint32_t block = open.back();
      open.pop_back();
      if (inside[block]) continue;
      inside[block] = true;
      blocks.push_back(block);
      for (std::uint32_t from : predecessors[block])
        if (reached(from)) open.push_back(from);
    }
    std::sort(blocks.begin(), blocks.end());
    loops_.push_back({header, no_loop, std::move(blocks)});
  }
  // Natural loops of different headers are nested or apart, so by size an outer loop comes before its inner
  // ones, and the last loop seen so far that holds a block is the innermost.
  std::stable_sort(loops_.begin(), loops_.end(),
                   [](const Loop& a, const Loop& b) { return a.blocks.size() > b.blocks.size(); });
  for (std::uint32_t loop = 0; loop < loops_.size(); ++loop) {
    loops_[loop].parent = loop_of_[loops_[loop].header];
    for (std::uint32_t block : loops_[loop].blocks) loop_of_[block] = loop;
  }
}

std::vector<std::uint32_t> ControlFlow::loop_contiguous_order() const {
  std::vector<std::uint32_t> order;
  if (successors_.empty()) return order;
  append_level(no_loop, order);
  std::vector<bool> placed(successors_.size());
  for (std::uint32_t block : order) placed[block] = true;
  for (std::uint32_t block = 0; block < successors_.size(); ++block)
    if (!placed[block]) order.push_back(block);
  return order;
}

// The blocks of `loop` in order: each loop directly inside stands for one node of a graph without its back
// edges.
void ControlFlow::append_level(std::uint32_t loop, std::vector<std::uint32_t>& order) const {
  // The node of a block is the header of the loop that is directly inside `loop` and holds it, else the
  // block.
  const auto inner_loop = [&](std::uint32_t block) {
    std::uint32_t inner = no_loop;
    for (std::uint32_t l = loop_of_[block]; l != loop; l = loops_[l].parent) inner = l;
    return inner;
  };
  const auto node = [&](std::uint32_t block) {
    const std::uint32_t inner = inner_loop(block);
    return inner == no_loop ? block : loops_[inner].header;
  };
  const std::uint32_t root = node(loop == no_loop ? 0 : loops_[loop].header);
  SuccessorLists level(successors_.size());
  for (std::uint32_t block = 0; block < successors_.size(); ++block) {
    if (!contains(loop, block)) continue;
    for (std::uint32_t to : successors_[block])
      if (contains(loop, to) && node(to) != root && node(to) != node(block))
        level[node(block)].push_back(node(to));
  }
  for (std::uint32_t block : reverse_post_order(level, root)) {
    const std::uint32_t inner = inner_loop(block);
    if (inner == no_loop) {
      order.push_back(block);
    } else {
      append_level(inner, order);
    }
  }
}

std::vector<std::uint32_t> ControlFlow::immediate_post_dominators(std::uint32_t loop) const {
  const auto exit = static_cast<std::uint32_t>(successors_.size());
  SuccessorLists backwards(successors_.size() + 1);
  for (std::uint32_t block = 0; block < exit; ++block) {
    if (!contains(loop, block)) continue;
    if (successors_[block].empty()) backwards[exit].push_back(block);
    for (std::uint32_t to : successors_[block]) {
      if (loop != no_loop && to == loops_[loop].header) {
        backwards[exit].push_back(block);
      } else if (contains(loop, to)) {
        backwards[to].push_back(block);
      }
    }
  }
  std::vector<std::uint32_t> dominator = immediate_dominators(backwards, exit);
  dominator.pop_back();
  std::replace(dominator.begin(), dominator.end(), exit, no_block);
  return dominator;
}

}  // namespace warpgrain::profiler
