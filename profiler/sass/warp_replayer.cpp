#include "profiler/sass/warp_replayer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>
#include <vector>

#include "profiler/sass/lane_mask.hpp"
#include "profiler/sass/lane_walker.hpp"
#include "profiler/sass/warp_groups.hpp"
#include "profiler/vector_clones.hpp"

namespace warpgrain::profiler::sass {
namespace {

class Replayer;

// A virtual function cannot be compiled for several processors; the loops over lanes gain from their
// instructions.
WARPGRAIN_VECTOR_CLONES void replay_warp(Replayer& replayer, std::span<const LaneTrace> lanes);

class Replayer final : public WarpReplayer {
 public:
  Replayer(const CodeGraph& code, const ReplayPlan& plan, const PtxDecisions& decisions,
           ReplayCounters& counters)
      : code_(code),
        plan_(plan),
        decisions_(decisions),
        counters_(counters),
        walker_(plan, decisions, counters),
        requests_(plan.memory, decisions, counters.requests),
        groups_(code, counters) {}

  void replay(std::span<const LaneTrace> lanes) override { replay_warp(*this, lanes); }

  void replay_lanes(std::span<const LaneTrace> lanes) {
    Mask alive = 0;
    const bool has_addresses =
        std::ranges::any_of(lanes, [](const LaneTrace& lane) { return lane.addresses != nullptr; });
    choices_.clear(has_addresses && requests_.ever_needs_ahead());
    const std::uint64_t out_of_step = counters_.out_of_step;
    for (std::uint32_t lane = 0; lane < lanes.size(); ++lane) {
      if (lanes[lane].blocks == nullptr) continue;
      alive |= Mask{1} << lane;
      next_choice_[lane] = static_cast<std::uint32_t>(choices_.size());
      walker_.walk(lanes[lane], choices_);
      choices_.add(Choices::none, trace_all);
    }
    if (alive == 0) return;
    ++counters_.warps;
    // What has no end for one of its lanes has none for the warp.
    if (counters_.out_of_step != out_of_step) return;
    requests_.begin_warp(lanes);
    lost_ = false;
    frames_.clear();
    groups_.begin(alive);
    for (WarpGroup group; groups_.next(group);) {
      run(group);
      if (lost_) groups_.give_up();
    }
    requests_.end_warp();
  }

 private:
  static constexpr std::uint32_t trace_all = 0xFFFFFFFF;
  struct Frame {
    std::uint32_t returns_to, caller;
  };

  // The lane's next choice, which stays its next until it has taken it. A lane without one has lost its way:
  // the warp is not followed any further.
  std::uint16_t choice_of(std::uint32_t lane) {
    const std::uint16_t way = choices_.ways()[next_choice_[lane]];
    if (way != Choices::none) return way;
    if (!lost_) ++counters_.out_of_step;
    lost_ = true;
    return 0;
  }

  // Runs a group until it waits, lets another run or ends.
  void run(WarpGroup group) {
    for (;;) {
      if (lost_) return groups_.partings().release(group.node);
      if (group.block == no_code) return groups_.end(group);
      const CodeBlock& block = code_.blocks[group.block];
      if (!issue(group, block)) return;
      switch (block.end) {
        case End::next:
          group.block = block.next;
          break;
        case End::exit:
          groups_.end(group);
          return;
        case End::call:
          enter(group, block);
          break;
        case End::ret:
          if (!leave_call(group)) {
            groups_.end(group);
            return;
          }
          break;
        case End::meet:
          if (!groups_.meet(group, block.barrier)) return;
          group.block = block.next;
          break;
        case End::warp_meet:
          if (!groups_.meet_warp(group)) return;
          group.block = block.next;
          break;
        case End::yield:
          group.block = block.next;
          if (groups_.yield(group)) return;
          break;
        case End::guard:
          if (!pass_guard(group, block)) return;
          break;
        case End::indirect:
          pass_table(group);
          break;
      }
    }
  }

  // Counts what the group issues of its block and does what that does to barriers. Whether it goes on then.
  bool issue(WarpGroup& group, const CodeBlock& block) {
    if (group.stand == Stand::decided) return true;
    const auto n_lanes = static_cast<std::uint32_t>(std::popcount(group.lanes));
    const std::size_t place = std::size_t{group.block} * (replayed_warp_width + 1) + n_lanes;
    if (group.stand == Stand::table) {
      ++counters_.issued_again[place];
      groups_.partings().issue(group.node, 1);
      return true;
    }
    if (group.stand == Stand::begin && leave_barriers(group, block)) return false;
    group.stand = Stand::begin;
    ++counters_.block_executions[place];
    groups_.partings().issue(group.node, block.last - block.first);
    if (!plan_.memory.of_block[group.block].empty()) count_requests(group);
    for (const MaskAction& action : block.actions) groups_.act(action, group.lanes);
    return true;
  }

  // The block's BREAKs under no predicate, which stand at its begin. Whether others run first then.
  bool leave_barriers(WarpGroup& group, const CodeBlock& block) {
    bool left = false;
    for (const MaskAction& action : block.actions)
      if (action.flow == Flow::leave && action.lanes == MaskAction::Lanes::all) {
        groups_.leave(action.barrier, group.lanes);
        left = true;
      }
    if (!left) return false;
    group.stand = Stand::left;
    return groups_.gives_way(group);
  }

  void count_requests(const WarpGroup& group) {
    std::array<std::uint32_t, replayed_warp_width> ahead{};
    const auto left_behind = [&](std::uint32_t lane) { ahead[lane] = choices_.entries(next_choice_[lane]); };
    if (requests_.needs_ahead(group.block)) for_lanes(group.lanes, left_behind);
    requests_.count(group.block, group.lanes, ahead);
  }

  void enter(WarpGroup& group, const CodeBlock& block) {
    frames_.push_back({block.next, group.frame});
    group.frame = static_cast<std::uint32_t>(frames_.size() - 1);
    group.block = block.target;
  }

  bool leave_call(WarpGroup& group) {
    if (group.frame == no_frame) return false;
    group.block = frames_[group.frame].returns_to;
    group.frame = frames_[group.frame].caller;
    return true;
  }

  Mask lanes_that_take(const Node& node, Mask lanes) {
    switch (node.rule) {
      case Rule::fast_path:
        return node.takes_fast_path ? lanes : 0;
      case Rule::together:
        if (lanes != groups_.alive()) ++counters_.stuck;
        return 0;
      default:
        return take_choices(lanes);
    }
  }

  // Of lanes at a guard, whose choices are 0 or 1. This is for every guard of every group.
  Mask take_choices(Mask lanes) {
    const std::uint16_t* const ways = choices_.ways();
    Mask taken = 0, all = 0;
    for_lanes(lanes, [&](std::uint32_t lane) {
      const Mask way = ways[next_choice_[lane]++];
      all |= way;
      taken |= way << lane;
    });
    if (all != Choices::none) return taken;
    ++counters_.out_of_step;
    lost_ = true;
    return 0;
  }

  static bool has_choices(const Node& node) {
    return node.rule != Rule::fast_path && node.rule != Rule::together;
  }

  // BREAKs of the lanes that take a guard, or of those that do not. Whether others run first then.
  bool leave_barriers(WarpGroup& group, const CodeBlock& block, Mask taken) {
    bool left = false;
    for (const MaskAction& action : block.actions)
      if (action.flow == Flow::leave && action.lanes != MaskAction::Lanes::all) {
        groups_.leave(action.barrier,
                      action.lanes == MaskAction::Lanes::taken ? taken : group.lanes & ~taken);
        left = true;
      }
    if (!left) return false;
    group.stand = Stand::decided;
    return groups_.gives_way(group);
  }

  // Whether the group, or the side of it that runs first, goes on: where its block says then.
  bool pass_guard(WarpGroup& group, const CodeBlock& block) {
    const Node& node = plan_.nodes[plan_.node_of[group.block]];
    const Mask taken = lanes_that_take(node, group.lanes);
    const Mask others = group.lanes & ~taken;
    if (group.stand == Stand::begin && leave_barriers(group, block, taken)) {
      // The guard comes again, with others perhaps.
      if (has_choices(node)) for_lanes(group.lanes, [&](std::uint32_t lane) { --next_choice_[lane]; });
      return false;
    }
    group.stand = Stand::begin;
    counters_.taken_lanes[group.block] += static_cast<std::uint64_t>(std::popcount(taken));
    if (taken == 0) {
      group.block = block.next;
      return true;
    }
    if (others == 0) return take(group, block);
    ++counters_.divergent[group.block];
    const std::uint32_t cause = cause_of(node);
    const std::uint64_t parting = groups_.new_parting();
    const WarpGroup rest{others, block.next, group.frame,
                         groups_.partings().part(group.node, cause, taken, parting)};
    WarpGroup part{taken, group.block, group.frame,
                   groups_.partings().part(group.node, cause, others, parting)};
    groups_.partings().release(group.node);
    if (!take(part, block)) {
      group = rest;
      return true;
    }
    const bool straight_first = std::popcount(others) <= std::popcount(taken);
    groups_.put_off(straight_first ? part : rest);
    group = straight_first ? rest : part;
    return true;
  }

  // Does what the lanes do that take a guard; whether they go on.
  bool take(WarpGroup& group, const CodeBlock& block) {
    switch (block.guarded) {
      case Flow::branch:
        group.block = block.target;
        return true;
      case Flow::call:
        enter(group, block);
        return true;
      case Flow::ret:
        if (leave_call(group)) return true;
        break;
      default:
        break;
    }
    groups_.end(group);
    return false;
  }

  std::uint32_t cause_of(const Node& node) const {
    return node.cause == no_decision ? counters_.never_used() : decisions_.blocks_of(node.cause)[0];
  }

  // Of lanes that go different ways those of one go, and the others issue the branch again: those that go
  // where the lowest lane goes, if they are no more than the others; else where the lowest of the others
  // goes.
  void pass_table(WarpGroup& group) {
    const Node& node = plan_.nodes[plan_.node_of[group.block]];
    const std::vector<std::uint32_t>& table = code_.blocks[group.block].table;
    const auto that_go_with = [&](Mask first_of) {
      const std::uint16_t entry = choice_of(static_cast<std::uint32_t>(std::countr_zero(first_of)));
      Mask same = 0;
      for_lanes(group.lanes, [&](std::uint32_t lane) { same |= Mask{choice_of(lane) == entry} << lane; });
      return same;
    };
    Mask lanes = that_go_with(group.lanes);
    if (lost_) return;
    if (const Mask others = group.lanes & ~lanes; std::popcount(lanes) > std::popcount(others) && others != 0)
      lanes = that_go_with(others);
    const Mask rest = group.lanes & ~lanes;
    const std::uint32_t block = group.block;
    group.block = table[choice_of(static_cast<std::uint32_t>(std::countr_zero(lanes)))];
    for_lanes(lanes, [&](std::uint32_t lane) { ++next_choice_[lane]; });
    const Stand stood = std::exchange(group.stand, Stand::begin);
    if (rest == 0) {
      if (stood == Stand::table) ++counters_.divergent[block];
      return;
    }
    const std::uint64_t parting = groups_.new_parting();
    const std::uint32_t cause = cause_of(node);
    const Partings::Node whole = group.node;
    groups_.put_off(
        {rest, block, group.frame, groups_.partings().part(whole, cause, lanes, parting), Stand::table});
    group.node = groups_.partings().part(whole, cause, rest, parting);
    group.lanes = lanes;
    groups_.partings().release(whole);
  }

  const CodeGraph& code_;
  const ReplayPlan& plan_;
  const PtxDecisions& decisions_;
  ReplayCounters& counters_;
  LaneWalker walker_;
  RequestCounter requests_;
  WarpGroups groups_;
  Choices choices_;                                               // of the warp's lanes, one after another
  std::array<std::uint32_t, replayed_warp_width> next_choice_{};  // among the choices
  bool lost_ = false;  // the replay and the lanes' traces have parted
  std::vector<Frame> frames_;
};

WARPGRAIN_VECTOR_CLONES [[gnu::flatten]] void replay_warp(Replayer& replayer,
                                                          std::span<const LaneTrace> lanes) {
  replayer.replay_lanes(lanes);
}

}  // namespace

std::unique_ptr<WarpReplayer> make_warp_replayer(const CodeGraph& code, const ReplayPlan& plan,
                                                 const PtxDecisions& decisions, ReplayCounters& counters) {
  return std::make_unique<Replayer>(code, plan, decisions, counters);
}

}  // namespace warpgrain::profiler::sass
