#pragma once
// Kernel graphs and lane traces made by hand, for tests that need no compiler.

#include <cstdint>
#include <fmt/format.h>
#include <random>
#include <string>
#include <vector>

#include "profiler/control_flow.hpp"
#include "profiler/kernel_graph.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler {

// A graph with the given successors; block b has weights[b] instructions (else 1), each on line b + 1 of
// "hand.cl".
inline KernelGraph hand_made_graph(const SuccessorLists& successors,
                                   const std::vector<std::size_t>& weights = {}) {
  KernelGraph graph;
  graph.kernel = "hand_made";
  graph.files = {"hand.cl"};
  graph.blocks.resize(successors.size());
  std::vector<bool> recorded(successors.size());
  recorded[0] = true;
  for (const auto& to : successors)
    if (to.size() > 1)
      for (std::uint32_t block : to) recorded[block] = true;
  for (std::uint32_t b = 0; b < successors.size(); ++b) {
    BasicBlock& block = graph.blocks[b];
    block.label = fmt::format("B{}", b);
    block.successors = successors[b];
    block.recorded = recorded[b];
    block.instructions.resize(weights.empty() ? 1 : weights[b],
                              {InstructionClass::integer, 0, {0, b + 1}, "add.s32 %r1, %r2, %r3;"});
    if (successors[b].size() > 1)
      block.instructions.back() = {InstructionClass::branch, 0, {0, b + 1}, "@%p1 bra $L;"};
  }
  return graph;
}

// Adds an access of `bytes` to the block, made by its first instruction.
inline void add_access(KernelGraph& graph, std::uint32_t block, InstructionClass access, std::uint8_t bytes) {
  graph.blocks[block].accesses.push_back({0, access, bytes});
}

// The traces of the lanes of one work-group.
class HandMadeTraces {
 public:
  // A lane that runs every block of `path` in turn and touches `addresses`.
  void add_lane(const KernelGraph& graph, const std::vector<std::uint32_t>& path,
                const std::vector<std::uint64_t>& addresses = {}) {
    std::vector<BlockIndex> entries;
    for (std::uint32_t block : path)
      if (graph.blocks[block].recorded) entries.push_back(static_cast<BlockIndex>(block));
    entries.push_back(trace_end);
    entries.resize(entries.size() + 3, 0);  // what trace.hpp promises readers
    blocks_.push_back(std::move(entries));
    addresses_.push_back(addresses);
  }
  void add_missing_lane() {
    blocks_.emplace_back();
    addresses_.emplace_back();
  }

  std::vector<LaneTrace> lanes() const {
    std::vector<LaneTrace> result;
    for (std::size_t lane = 0; lane < blocks_.size(); ++lane)
      result.push_back({blocks_[lane].empty() ? nullptr : blocks_[lane].data(),
                        addresses_[lane].empty() ? nullptr : addresses_[lane].data()});
    return result;
  }

 private:
  std::vector<std::vector<BlockIndex>> blocks_;
  std::vector<std::vector<std::uint64_t>> addresses_;
};

// A random kernel of nested if, if-else, switch, loops with break and continue, and early returns.
class RandomKernel {
 public:
  explicit RandomKernel(std::uint64_t seed) : random_(seed) {
    const std::uint32_t entry = new_block();
    const std::uint32_t last = sequence(entry, 3, no_block, no_block);
    if (last != no_block) successors_[last] = {};
    std::vector<std::size_t> weights;
    for (std::size_t b = 0; b < successors_.size(); ++b) weights.push_back(1 + random_() % 9);
    graph_ = hand_made_graph(successors_, weights);
    for (std::uint32_t b = 0; b < successors_.size(); ++b) {
      const std::uint8_t sizes[] = {1, 4, 8, 16};
      const InstructionClass classes[] = {InstructionClass::global_load, InstructionClass::global_store,
                                          InstructionClass::shared_load, InstructionClass::atomic};
      for (auto n = random_() % 3; n > 0; --n)
        add_access(graph_, b, classes[random_() % 4], sizes[random_() % 4]);
    }
  }

  KernelGraph& graph() { return graph_; }

  // A warp's lanes: mostly of one mind at a branch, so that groups of all sizes come about. `exist` lanes of
  // `width`.
  HandMadeTraces warp(std::uint32_t width, std::uint64_t exist, bool addresses) {
    HandMadeTraces traces;
    const std::uint64_t common = random_();
    for (std::uint32_t lane = 0; lane < width; ++lane) {
      if ((exist >> lane & 1) == 0) {
        traces.add_missing_lane();
        continue;
      }
      const std::vector<std::uint32_t> path = walk(common);
      std::vector<std::uint64_t> touched;
      if (addresses) touched = addresses_of(path, lane);
      traces.add_lane(graph_, path, touched);
    }
    return traces;
  }

 private:
  std::uint32_t new_block() {
    successors_.emplace_back();
    return static_cast<std::uint32_t>(successors_.size() - 1);
  }
  std::uint32_t block_after(std::uint32_t from) {
    const std::uint32_t block = new_block();
    successors_[from].push_back(block);
    return block;
  }

  // Appends statements behind `at`; the block that flow goes on from, or no_block when it never does.
  std::uint32_t sequence(std::uint32_t at, int depth, std::uint32_t header, std::uint32_t exit) {
    for (auto n = 1 + random_() % 3; n > 0 && at != no_block; --n) at = statement(at, depth, header, exit);
    return at;
  }

  std::uint32_t statement(std::uint32_t at, int depth, std::uint32_t header, std::uint32_t exit) {
    const auto kind = random_() % 10;
    if (depth == 0 || kind == 0) return block_after(at);
    if (kind <= 5) return choice(at, kind <= 3 ? 1 + kind % 2 : 2 + random_() % 3, depth, header, exit);
    if (kind <= 7) return loop(at, depth);
    if (kind == 8 && header != no_block) {  // if (...) break; or continue;
      successors_[at].push_back(random_() % 2 == 0 ? header : exit);
      return block_after(at);
    }
    const std::uint32_t end = block_after(at);  // if (...) return;
    successors_[end] = {};
    return block_after(at);
  }

  std::uint32_t choice(std::uint32_t at, std::uint64_t n_arms, int depth, std::uint32_t header,
                       std::uint32_t exit) {
    std::vector<std::uint32_t> ends;
    for (std::uint64_t arm = 0; arm < n_arms; ++arm) {
      const std::uint32_t end = sequence(block_after(at), depth - 1, header, exit);
      if (end != no_block) ends.push_back(end);
    }
    const std::uint32_t join = new_block();
    if (n_arms == 1) successors_[at].push_back(join);
    for (std::uint32_t end : ends) successors_[end].push_back(join);
    return join;
  }

  std::uint32_t loop(std::uint32_t at, int depth) {
    const std::uint32_t header = block_after(at);
    const std::uint32_t exit = new_block();
    const std::uint32_t end = sequence(block_after(header), depth - 1, header, exit);
    successors_[header].push_back(exit);
    successors_[end].push_back(header);
    return exit;
  }

  std::vector<std::uint32_t> walk(std::uint64_t common) {
    std::vector<std::uint32_t> path{0};
    while (!graph_.blocks[path.back()].successors.empty()) {
      const auto& to = graph_.blocks[path.back()].successors;
      std::uint64_t choice = random_() % 4 == 0 ? random_() : (common >> path.size() % 32) + path.back();
      // A long walk is led out: of loops by their header's exit, which comes last, and never back by
      // `continue`.
      if (path.size() > 200) choice = to.size() - 1;
      path.push_back(to[choice % to.size()]);
    }
    return path;
  }

  std::vector<std::uint64_t> addresses_of(const std::vector<std::uint32_t>& path, std::uint32_t lane) {
    std::vector<std::uint64_t> touched;
    for (std::uint32_t block : path)
      for (const MemoryAccess& access : graph_.blocks[block].accesses) {
        const std::uint64_t base = 0x10000 + 0x1000 * block;
        if (random_() % 8 == 0) {
          touched.push_back(no_address);
          continue;
        }
        touched.push_back(random_() % 2 == 0 ? base + lane * access.bytes : base + random_() % 600);
      }
    touched.push_back(0);  // a lane without accesses has addresses all the same
    return touched;
  }

  std::mt19937_64 random_;
  SuccessorLists successors_;
  KernelGraph graph_;
};

}  // namespace warpgrain::profiler
