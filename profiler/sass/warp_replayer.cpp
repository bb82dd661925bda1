#include "profiler/sass/warp_replayer.hpp"

#include <array>
#include <bit>
#include <vector>

#include "profiler/partings.hpp"
#include "profiler/sass/lane_mask.hpp"
#include "profiler/sass/lane_walker.hpp"

namespace warpgrain::profiler::sass {
namespace {

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
        partings_(counters.lane_slots_lost) {}

  void replay(std::span<const LaneTrace> lanes) override {
    alive_ = 0;
    choices_.clear();
    std::array<std::size_t, replayed_warp_width> begins{}, ends{};
    const std::uint64_t out_of_step = counters_.out_of_step;
    for (std::uint32_t lane = 0; lane < lanes.size(); ++lane) {
      if (lanes[lane].blocks == nullptr) continue;
      alive_ |= Mask{1} << lane;
      begins[lane] = choices_.size();
      walker_.walk(lanes[lane], choices_);
      ends[lane] = choices_.size();
    }
    if (alive_ == 0) return;
    ++counters_.warps;
    // What has no end for one of its lanes has none for the warp.
    if (counters_.out_of_step != out_of_step) return;
    for_lanes(alive_, [&](std::uint32_t lane) {
      next_choice_[lane] = choices_.data() + begins[lane];
      last_choice_[lane] = choices_.data() + ends[lane];
    });
    requests_.begin_warp(lanes);
    lost_ = false;
    for (auto& of_barrier : expected_) of_barrier.fill(0);
    frames_.clear();
    ready_.push_back({alive_, 0, no_frame, partings_.root(counters_.never_used(), ~alive_)});
    while (!ready_.empty() || !waiting_.empty()) {
      if (ready_.empty() && !release_any()) force_release();
      while (!ready_.empty()) {
        const Group group = ready_.back();
        ready_.pop_back();
        run(group);
      }
      if (lost_) give_up();
    }
    requests_.end_warp();
  }

 private:
  static constexpr std::uint32_t no_frame = 0xFFFFFFFF, trace_all = 0xFFFFFFFF;
  struct Group {
    Mask lanes;
    std::uint32_t block;
    std::uint32_t frame;
    Partings::Node node;
  };
  struct Frame {
    std::uint32_t returns_to, caller;
  };

  // The lane's next choice. A lane without one has lost its way: the warp is not followed any further.
  std::uint16_t choose(std::uint32_t lane) {
    if (next_choice_[lane] != last_choice_[lane]) return next_choice_[lane]++->way;
    if (!lost_) ++counters_.out_of_step;
    lost_ = true;
    return 0;
  }

  void give_up() {
    for (const std::vector<Group>* groups : {&ready_, &waiting_})
      for (const Group& group : *groups) partings_.release(group.node);
    ready_.clear();
    waiting_.clear();
  }

  // Runs a group until it waits, parts or ends.
  void run(Group group) {
    const auto n_lanes = static_cast<std::uint32_t>(std::popcount(group.lanes));
    for (;;) {
      if (lost_) return partings_.release(group.node);
      if (group.block == no_code) return end(group);
      const CodeBlock& block = code_.blocks[group.block];
      ++counters_.block_executions[std::size_t{group.block} * (replayed_warp_width + 1) + n_lanes];
      partings_.issue(group.node, block.last - block.first);
      if (!plan_.memory.of_block[group.block].empty()) count_requests(group);
      for (const MaskAction& action : block.actions) act(action, group.lanes);
      if (left_ && !waiting_.empty()) release_any();
      left_ = false;
      switch (block.end) {
        case End::next:
          group.block = block.next;
          break;
        case End::exit:
          end(group);
          return;
        case End::call:
          enter(group, block);
          break;
        case End::ret:
          if (!leave_call(group)) {
            end(group);
            return;
          }
          break;
        case End::meet:
          if (!comes_alone(group, block.barrier)) {
            waiting_.push_back(group);
            release_any();
            return;
          }
          group.block = block.next;
          break;
        case End::warp_meet:
          if (group.lanes != alive_) {
            waiting_.push_back(group);
            return;
          }
          group.block = block.next;
          break;
        case End::guard:
          if (!pass_guard(group, block)) return;
          break;
        case End::indirect:
          if (!pass_table(group)) return;
          break;
      }
    }
  }

  void count_requests(const Group& group) {
    std::array<std::uint32_t, replayed_warp_width> ahead{};
    const auto left_behind = [&](std::uint32_t lane) {
      ahead[lane] = next_choice_[lane] == last_choice_[lane] ? trace_all : next_choice_[lane]->entries;
    };
    if (requests_.needs_ahead(group.block)) for_lanes(group.lanes, left_behind);
    requests_.count(group.block, group.lanes, ahead);
  }

  void act(const MaskAction& action, Mask lanes) {
    switch (action.flow) {
      case Flow::open:
        for_lanes(lanes, [&](std::uint32_t lane) { expected_[action.barrier][lane] = lanes; });
        break;
      case Flow::leave:
        if (action.lanes == MaskAction::Lanes::all) leave(action.barrier, lanes);
        break;
      case Flow::save:
        for_lanes(lanes,
                  [&](std::uint32_t lane) { saved_[action.reg][lane] = expected_[action.barrier][lane]; });
        break;
      case Flow::restore:
        for_lanes(lanes,
                  [&](std::uint32_t lane) { expected_[action.barrier][lane] = saved_[action.reg][lane]; });
        break;
      default:
        break;
    }
  }

  void leave(std::uint8_t barrier, Mask lanes) {
    Mask others = 0;
    for_lanes(lanes, [&](std::uint32_t lane) { others |= expected_[barrier][lane]; });
    for_lanes(others, [&](std::uint32_t lane) { expected_[barrier][lane] &= ~lanes; });
    left_ = true;
  }

  void issue_again(const Group& group, std::uint32_t block) {
    const auto n_lanes = static_cast<std::uint32_t>(std::popcount(group.lanes));
    ++counters_.issued_again[std::size_t{block} * (replayed_warp_width + 1) + n_lanes];
    partings_.issue(group.node, 1);
  }

  void enter(Group& group, const CodeBlock& block) {
    frames_.push_back({block.next, group.frame});
    group.frame = static_cast<std::uint32_t>(frames_.size() - 1);
    group.block = block.target;
  }

  bool leave_call(Group& group) {
    if (group.frame == no_frame) return false;
    group.block = frames_[group.frame].returns_to;
    group.frame = frames_[group.frame].caller;
    return true;
  }

  void end(const Group& group) {
    alive_ &= ~group.lanes;
    partings_.release(group.node);
    if (!waiting_.empty()) release_any();
  }

  Mask expected(const Group& group, std::uint8_t barrier) const {
    return expected_[barrier][static_cast<std::size_t>(std::countr_zero(group.lanes))] & alive_;
  }
  bool comes_alone(const Group& group, std::uint8_t barrier) const {
    return (expected(group, barrier) & ~group.lanes) == 0;
  }

  // Lets groups go on whose others have all come, ended or left. Whether there was one.
  bool release_any() {
    bool released = false;
    for (std::size_t k = 0; k < waiting_.size();) {
      const CodeBlock& block = code_.blocks[waiting_[k].block];
      Mask here = 0;
      for (const Group& other : waiting_)
        if (other.block == waiting_[k].block) here |= other.lanes;
      const Mask needed =
          block.end == End::warp_meet ? alive_ : expected(waiting_[k], block.barrier) | waiting_[k].lanes;
      if ((needed & ~here) != 0) {
        ++k;
        continue;
      }
      release(waiting_[k].block, needed);
      released = true;
      k = 0;
    }
    return released;
  }

  // Joins the groups at a block that hold some of these lanes.
  void release(std::uint32_t at, Mask lanes) {
    Group joined{0, code_.blocks[at].next, no_frame, 0};
    for (std::size_t k = 0; k < waiting_.size();) {
      if (waiting_[k].block != at || (waiting_[k].lanes & lanes) == 0) {
        ++k;
        continue;
      }
      if (left_) issue_again(waiting_[k], at);
      joined.node = joined.lanes == 0
                        ? waiting_[k].node
                        : partings_.join(joined.node, waiting_[k].node, joined.lanes | waiting_[k].lanes);
      joined.lanes |= waiting_[k].lanes;
      joined.frame = waiting_[k].frame;
      waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(k));
    }
    ready_.push_back(joined);
  }

  // Nobody can go on. WARPSYNC's mask is in a register that the replay does not know: it meets those that
  // have come when no other can.
  void force_release() {
    std::size_t chosen = waiting_.size();
    for (std::size_t k = 0; k < waiting_.size(); ++k) {
      if (code_.blocks[waiting_[k].block].end != End::warp_meet) continue;
      if (chosen == waiting_.size() || waiting_[k].block < waiting_[chosen].block) chosen = k;
    }
    if (chosen == waiting_.size()) {
      ++counters_.stuck;
      chosen = 0;
      for (std::size_t k = 1; k < waiting_.size(); ++k)
        if (waiting_[k].block < waiting_[chosen].block) chosen = k;
    }
    release(waiting_[chosen].block, ~Mask{0});
  }

  Mask lanes_that_take(const Node& node, Mask lanes) {
    switch (node.rule) {
      case Rule::fast_path:
        return node.takes_fast_path ? lanes : 0;
      case Rule::together:
        if (lanes != alive_) ++counters_.stuck;
        return 0;
      default: {
        Mask taken = 0;
        for_lanes(lanes, [&](std::uint32_t lane) { taken |= Mask{choose(lane)} << lane; });
        return taken;
      }
    }
  }

  // Whether the whole group goes on, where its block says then.
  bool pass_guard(Group& group, const CodeBlock& block) {
    const Node& node = plan_.nodes[plan_.node_of[group.block]];
    const Mask taken = lanes_that_take(node, group.lanes);
    const Mask others = group.lanes & ~taken;
    counters_.taken_lanes[group.block] += static_cast<std::uint64_t>(std::popcount(taken));
    for (const MaskAction& action : block.actions)
      if (action.flow == Flow::leave && action.lanes != MaskAction::Lanes::all)
        leave(action.barrier, action.lanes == MaskAction::Lanes::taken ? taken : others);
    if (left_ && !waiting_.empty()) release_any();
    left_ = false;
    if (taken == 0) {
      group.block = block.next;
      return true;
    }
    if (others != 0) {
      ++counters_.divergent[group.block];
      const std::uint32_t cause = cause_of(node);
      ++n_partings_;
      const Group rest{others, block.next, group.frame,
                       partings_.part(group.node, cause, taken, n_partings_)};
      Group part{taken, group.block, group.frame, partings_.part(group.node, cause, others, n_partings_)};
      partings_.release(group.node);
      ready_.push_back(rest);
      if (take(part, block)) ready_.push_back(part);
      return false;
    }
    return take(group, block);
  }

  // Does what the lanes do that take a guard; whether they go on.
  bool take(Group& group, const CodeBlock& block) {
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
    end(group);
    return false;
  }

  std::uint32_t cause_of(const Node& node) const {
    return node.cause == no_decision ? counters_.never_used() : decisions_.blocks_of(node.cause)[0];
  }

  bool pass_table(Group& group) {
    const Node& node = plan_.nodes[plan_.node_of[group.block]];
    const std::vector<std::uint32_t>& table = code_.blocks[group.block].table;
    std::array<std::uint16_t, replayed_warp_width> chosen{};
    for_lanes(group.lanes, [&](std::uint32_t lane) { chosen[lane] = choose(lane); });
    const auto first = static_cast<std::size_t>(std::countr_zero(group.lanes));
    const auto that_go = [&](Mask lanes, std::uint16_t entry) {
      Mask same = 0;
      for_lanes(lanes, [&](std::uint32_t lane) { same |= Mask{chosen[lane] == entry} << lane; });
      return same;
    };
    Mask left = group.lanes & ~that_go(group.lanes, chosen[first]);
    if (left == 0) {
      group.block = table[chosen[first]];
      return true;
    }
    ++counters_.divergent[group.block];
    ++n_partings_;
    const std::uint32_t cause = cause_of(node);
    for (left = group.lanes; left != 0;) {
      const std::uint16_t entry = chosen[static_cast<std::size_t>(std::countr_zero(left))];
      const Mask lanes = that_go(left, entry);
      left &= ~lanes;
      Group part{lanes, table[entry], group.frame,
                 partings_.part(group.node, cause, group.lanes & ~lanes, n_partings_)};
      if (left != 0) issue_again({left, 0, no_frame, group.node}, group.block);
      ready_.push_back(part);
    }
    partings_.release(group.node);
    return false;
  }

  const CodeGraph& code_;
  const ReplayPlan& plan_;
  const PtxDecisions& decisions_;
  ReplayCounters& counters_;
  LaneWalker walker_;
  RequestCounter requests_;
  Partings partings_;
  Choices choices_;  // of the warp's lanes, one after another
  std::array<const Choice*, replayed_warp_width> next_choice_{}, last_choice_{};
  bool lost_ = false;  // the replay and the lanes' traces have parted
  Mask alive_ = 0;
  std::uint64_t n_partings_ = 0;
  bool left_ = false;                   // lanes have just left a barrier's mask
  std::vector<Group> ready_, waiting_;  // groups that wait stand at the block where they do
  std::vector<Frame> frames_;
  // Which lanes a lane of that barrier, or of that register, waits for.
  std::array<std::array<Mask, replayed_warp_width>, 16> expected_{};
  std::array<std::array<Mask, replayed_warp_width>, 256> saved_{};
};

}  // namespace

std::unique_ptr<WarpReplayer> make_warp_replayer(const CodeGraph& code, const ReplayPlan& plan,
                                                 const PtxDecisions& decisions, ReplayCounters& counters) {
  return std::make_unique<Replayer>(code, plan, decisions, counters);
}

}  // namespace warpgrain::profiler::sass
