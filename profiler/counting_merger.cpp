// The fast merger: the same sums as the plain one in merge.cpp, which the tests hold it to.
//
// What makes it fast: lanes of a group are packed, so that loops over them are short; the next four blocks of
// all lanes are compared in one pass, so that a group that stays together mostly costs one table look-up a
// block; waiting groups are kept in order of their place, so that one comparison says whether the running
// group goes on; instructions and idle lanes are counted per stretch that a group runs, not per block.
//
// Under ipdom the groups are a stack in place of a list by place. Behind the parts of a group stands an entry
// for the post-dominator at which they meet again; it gathers the parts as they come there, and runs when it
// is on top.

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <vector>

#include "profiler/coalescing.hpp"
#include "profiler/control_flow.hpp"
#include "profiler/merge.hpp"
#include "profiler/partings.hpp"
#include "profiler/reconvergence.hpp"
#include "profiler/vector_clones.hpp"

namespace warpgrain::profiler {
namespace {

constexpr std::uint32_t no_rank = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t entries_ahead = sizeof(std::uint64_t) / sizeof(BlockIndex);

template <bool stacked>
class CountingMerger;

// A virtual function or a template cannot be compiled for several processors; the bit loops gain from their
// instructions.
WARPGRAIN_VECTOR_CLONES void merge_warp(CountingMerger<false>& merger, std::span<const LaneTrace> traces);
WARPGRAIN_VECTOR_CLONES void merge_warp(CountingMerger<true>& merger, std::span<const LaneTrace> traces);

template <bool stacked>
class CountingMerger : public WarpMerger {
 public:
  CountingMerger(const KernelGraph& graph, MergePolicy policy, WarpCounters& counters)
      : counters_(counters), partings_(counters.lane_slots_lost) {
    const Reconvergence reconvergence = find_reconvergence(graph);
    for (std::uint32_t b = 0; b < graph.blocks.size(); ++b) {
      const BasicBlock& block = graph.blocks[b];
      Step step;
      step.rank = reconvergence.rank[b];
      step.join = policy == MergePolicy::min_pc || reconvergence.join[b];
      step.instructions = static_cast<std::uint32_t>(block.instructions.size());
      step.n_accesses = static_cast<std::uint32_t>(block.accesses.size());
      step.first_access = static_cast<std::uint32_t>(access_bytes_.size());
      step.n_successors = static_cast<std::uint32_t>(block.successors.size());
      if (!block.successors.empty()) step.first_successor = block.successors[0];
      step.meeting = reconvergence.immediate_post_dominator[b];
      step.chained = block.successors.size() == 1 && !graph.blocks[block.successors[0]].recorded;
      steps_.push_back(step);
      for (const MemoryAccess& access : block.accesses) access_bytes_.push_back(access.bytes);
    }
  }

  void merge(std::span<const LaneTrace> traces) override { merge_warp(*this, traces); }

  void merge_lanes(std::span<const LaneTrace> traces) {
    std::uint64_t lanes = 0;
    for (std::size_t lane = 0; lane < traces.size(); ++lane) {
      if (traces[lane].blocks == nullptr) continue;
      lanes |= std::uint64_t{1} << lane;
      blocks_[lane] = traces[lane].blocks + 1;  // the first is the entry
      addresses_[lane] = traces[lane].addresses;
    }
    if (lanes == 0) return;
    ++counters_.warps;
    with_addresses_ = addresses_[static_cast<std::size_t>(std::countr_zero(lanes))] != nullptr;
    n_partings_ = 0;
    const std::uint64_t width_mask = std::numeric_limits<std::uint64_t>::max() >> (64 - counters_.warp_width);
    waiting_[0] = {lanes, 0, steps_[0].rank, partings_.root(counters_.never_used(), width_mask & ~lanes)};
    n_waiting_ = 1;
    while (n_waiting_ != 0) {
      const Group group = waiting_[--n_waiting_];
      if (stacked && group.block == group.until)
        arrive(group);
      else
        run(group);
    }
  }

 private:
  struct Step {  // what merging needs to know of a block
    std::uint32_t rank = 0;
    std::uint32_t instructions = 0;
    std::uint32_t n_accesses = 0, first_access = 0;
    std::uint32_t n_successors = 0, first_successor = 0;
    std::uint32_t meeting = 0;  // the immediate post-dominator
    bool join = false;
    bool chained = false;  // goes to its only successor, and that is not recorded
  };
  struct Group {
    std::uint64_t lanes;
    std::uint32_t block, rank;
    Partings::Node node;
    // Of a stacked group: the block at which it ends, and the entry of waiting_ that gathers it there.
    std::uint32_t until = no_block, gathered_in = 0;
  };

  // Runs a group until it reaches another one's place, parts, or ends.
  void run(const Group group) {
    load(group.lanes);
    const std::uint32_t bound = n_waiting_ == 0 ? no_rank : waiting_[n_waiting_ - 1].rank;
    std::uint64_t* const executions = counters_.block_executions.data() + n_lanes_;
    const std::size_t stride = counters_.warp_width + 1;
    std::uint64_t instructions = 0;
    std::uint32_t ahead = 0;  // entries of the traces that are known to be the same for all
    std::uint32_t block = group.block;
    for (;;) {
      const Step& step = steps_[block];
      ++executions[block * stride];
      instructions += step.instructions;
      if (with_addresses_ && step.n_accesses != 0) count_accesses(step);
      if (step.n_successors == 0) {
        issue(group, instructions);
        partings_.release(group.node);
        return;
      }
      std::uint32_t next = step.first_successor;
      if (!step.chained) {
        if (ahead == 0) ahead = common_entries();
        if (ahead == 0) {
          issue(group, instructions);
          part(group, block);
          return;
        }
        --ahead;
        next = lane_blocks_[0][n_read_++];
        if (step.n_successors > 1 && next == step.first_successor) counters_.taken_lanes[block] += n_lanes_;
      }
      const Step& next_step = steps_[next];
      const bool stops = stacked ? next == group.until
                                 : next_step.rank > bound || (next_step.rank == bound && next_step.join);
      if (stops) {
        issue(group, instructions);
        store();
        const Group stopped{group.lanes, next, next_step.rank, group.node, group.until, group.gathered_in};
        stacked ? arrive(stopped) : wait(stopped);
        return;
      }
      block = next;
    }
  }

  void issue(const Group& group, std::uint64_t instructions) {
    counters_.issued.warp_instructions += instructions;
    counters_.issued.thread_instructions += instructions * n_lanes_;
    partings_.issue(group.node, instructions);
  }

  // Packs the lanes of a group.
  void load(std::uint64_t lanes) {
    n_lanes_ = 0;
    n_read_ = 0;
    n_addresses_read_ = 0;
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
      lane_[n_lanes_] = lane;
      lane_blocks_[n_lanes_] = blocks_[lane];
      ++n_lanes_;
    }
    if (!with_addresses_) return;
    for (std::uint32_t i = 0; i < n_lanes_; ++i) lane_addresses_[i] = addresses_[lane_[i]];
  }

  void store() {
    for (std::uint32_t i = 0; i < n_lanes_; ++i) blocks_[lane_[i]] = lane_blocks_[i] + n_read_;
    if (!with_addresses_) return;
    for (std::uint32_t i = 0; i < n_lanes_; ++i)
      addresses_[lane_[i]] = lane_addresses_[i] + n_addresses_read_;
  }

  // How many of the next four entries are the same for all lanes.
  std::uint32_t common_entries() const {
    std::uint64_t first, differences = 0;
    std::memcpy(&first, lane_blocks_[0] + n_read_, sizeof first);
    for (std::uint32_t i = 1; i < n_lanes_; ++i) {
      std::uint64_t entries;
      std::memcpy(&entries, lane_blocks_[i] + n_read_, sizeof entries);
      differences |= entries ^ first;
    }
    static_assert(std::endian::native == std::endian::little, "the first entry is expected in the low bits");
    return static_cast<std::uint32_t>(std::countr_zero(differences)) / (8 * sizeof(BlockIndex));
  }

  // The lanes of the group go different ways from `block`.
  void part(const Group& group, std::uint32_t block) {
    ++counters_.divergent[block];
    ++n_partings_;
    const std::size_t at = n_read_++;
    const std::uint32_t n_ways = steps_[block].n_successors;
    const std::uint32_t meeting = steps_[block].meeting, gathered_in = n_waiting_;
    if (stacked && meeting != no_block)
      waiting_[n_waiting_++] = {0, meeting, steps_[meeting].rank, group.node, group.until, group.gathered_in};
    std::uint64_t left = group.lanes;
    while (left != 0) {
      // The lowest lane that is left, and all that go with it: with two ways, after the first one all that
      // are left.
      const std::uint32_t to = blocks_[static_cast<std::size_t>(std::countr_zero(left))][at];
      const std::uint64_t lanes = n_ways == 2 && left != group.lanes ? left : left & lanes_that_go(at, to);
      left &= ~lanes;
      if (to == steps_[block].first_successor)
        counters_.taken_lanes[block] += static_cast<std::uint64_t>(std::popcount(lanes));
      const Group part{lanes,           to,
                       steps_[to].rank, partings_.part(group.node, block, group.lanes & ~lanes, n_partings_),
                       meeting,         gathered_in};
      if (!stacked)
        wait(part);
      else if (to == meeting)
        arrive(part);
      else
        waiting_[n_waiting_++] = part;
    }
    store();
    partings_.release(group.node);
  }

  // The lanes of the group whose entry at `at` is `to`.
  std::uint64_t lanes_that_go(std::size_t at, std::uint32_t to) const {
    std::uint64_t lanes = 0;
    for (std::uint32_t i = 0; i < n_lanes_; ++i)
      lanes |= std::uint64_t{lane_blocks_[i][at] == to} << lane_[i];
    return lanes;
  }

  // Puts a group among those that wait, or into the one that waits where it is going to join. The lowest
  // comes last.
  void wait(const Group& group) {
    std::uint32_t place = n_waiting_;
    while (place != 0 && waiting_[place - 1].rank < group.rank) --place;
    if (place != 0 && waiting_[place - 1].rank == group.rank && steps_[group.block].join) {
      Group& other = waiting_[place - 1];
      other.lanes |= group.lanes;
      other.node = partings_.join(other.node, group.node, other.lanes);
      return;
    }
    for (std::uint32_t i = n_waiting_; i > place; --i) waiting_[i] = waiting_[i - 1];
    waiting_[place] = group;
    ++n_waiting_;
  }

  // A stacked group has come to the block at which the parts of its parent meet.
  void arrive(const Group& group) {
    Group& gathered = waiting_[group.gathered_in];
    gathered.node = gathered.lanes == 0
                        ? group.node
                        : partings_.join(gathered.node, group.node, gathered.lanes | group.lanes);
    gathered.lanes |= group.lanes;
  }

  void count_accesses(const Step& step) {
    for (std::uint32_t k = 0; k < step.n_accesses; ++k, ++n_addresses_read_) {
      std::array<std::uint64_t, max_warp_width> addresses;
      std::size_t n = 0;
      for (std::uint32_t i = 0; i < n_lanes_; ++i) {
        addresses[n] = lane_addresses_[i][n_addresses_read_];
        n += addresses[n] != no_address ? 1 : 0;
      }
      count_request(counters_.accesses[step.first_access + k], std::span(addresses).first(n),
                    access_bytes_[step.first_access + k]);
    }
  }

  WarpCounters& counters_;
  Partings partings_;
  std::vector<Step> steps_;                  // [n_blocks]
  std::vector<std::uint32_t> access_bytes_;  // of each access, as WarpCounters::accesses
  bool with_addresses_ = false;
  std::uint64_t n_partings_ = 0;

  // What each lane reads next, [warp_width].
  std::array<const BlockIndex*, max_warp_width> blocks_{};
  std::array<const std::uint64_t*, max_warp_width> addresses_{};

  // The running group, packed: lane numbers and what they read first; n_read_ entries further they are now.
  std::uint32_t n_lanes_ = 0;
  std::array<std::uint32_t, max_warp_width> lane_{};
  std::array<const BlockIndex*, max_warp_width> lane_blocks_{};
  std::array<const std::uint64_t*, max_warp_width> lane_addresses_{};
  std::size_t n_read_ = 0, n_addresses_read_ = 0;

  // By rank, highest first; of the same rank, the one that came last is the last. As a stack it holds at most
  // twice as many: each lane is in one entry, and an entry that gathers without lanes has two groups or more
  // above it.
  std::array<Group, std::size_t{2} * max_warp_width> waiting_{};
  std::uint32_t n_waiting_ = 0;
};

WARPGRAIN_VECTOR_CLONES [[gnu::flatten]] void merge_warp(CountingMerger<false>& merger,
                                                         std::span<const LaneTrace> traces) {
  merger.merge_lanes(traces);
}

WARPGRAIN_VECTOR_CLONES [[gnu::flatten]] void merge_warp(CountingMerger<true>& merger,
                                                         std::span<const LaneTrace> traces) {
  merger.merge_lanes(traces);
}

}  // namespace

std::unique_ptr<WarpMerger> make_counting_merger(const KernelGraph& graph, MergePolicy policy,
                                                 WarpCounters& counters) {
  if (policy == MergePolicy::ipdom) return std::make_unique<CountingMerger<true>>(graph, policy, counters);
  return std::make_unique<CountingMerger<false>>(graph, policy, counters);
}

}  // namespace warpgrain::profiler
