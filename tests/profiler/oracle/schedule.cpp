#include "tests/profiler/oracle/schedule.hpp"

#include <stdexcept>

namespace warpgrain::oracle {
namespace {

// loop_postdom and min_pc: the group at the lowest rank runs.
class RankedSchedule : public Schedule {
 public:
  RankedSchedule(Lanes lanes, const std::vector<std::uint32_t>& rank, const std::vector<bool>& join)
      : rank_(rank), join_(join), waiting_{{0, lanes}} {}

  std::optional<Group> next() override {
    if (waiting_.empty()) return std::nullopt;
    std::size_t chosen = 0;
    for (std::size_t i = 1; i < waiting_.size(); ++i)
      if (rank_[waiting_[i].at] <= rank_[waiting_[chosen].at]) chosen = i;  // the last to come, of equals
    Group group{waiting_[chosen].at, 0};
    std::vector<Group> others;
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      if (i == chosen || (join_[group.at] && waiting_[i].at == group.at)) {
        group.lanes |= waiting_[i].lanes;
      } else {
        others.push_back(waiting_[i]);
      }
    }
    waiting_ = std::move(others);
    return group;
  }

  void went(const std::vector<Group>& parts) override {
    for (const Group& part : parts) waiting_.push_back(part);
  }

 private:
  const std::vector<std::uint32_t>& rank_;
  const std::vector<bool>& join_;
  std::vector<Group> waiting_;  // in the order in which they came
};

// ipdom: lanes that part are run one part after the other up to the post-dominator, where they are gathered.
class GatheringSchedule : public Schedule {
 public:
  GatheringSchedule(Lanes lanes, const std::vector<Node>& post_dominators, Node end)
      : post_dominators_(post_dominators), end_(end), stack_{{{0, lanes}, end, 0}} {}

  std::optional<Group> next() override {
    while (!stack_.empty()) {
      const Level top = stack_.back();
      if (top.group.lanes != 0 && top.group.at != top.stop) return top.group;
      stack_.pop_back();
      if (top.group.lanes != 0) stack_[top.gathered_by].group.lanes |= top.group.lanes;
    }
    return std::nullopt;
  }

  void went(const std::vector<Group>& parts) override {
    Level& level = stack_.back();
    if (parts.empty()) {
      level.group.lanes = 0;
    } else if (parts.size() == 1) {
      level.group = parts[0];
    } else {
      const Node meeting = post_dominators_[level.group.at];
      level.group = {meeting, 0};
      if (meeting == end_) stack_.pop_back();  // none of them comes back
      const std::size_t gathered_by = stack_.empty() ? 0 : stack_.size() - 1;
      for (const Group& part : parts) stack_.push_back({part, meeting, gathered_by});
    }
  }

 private:
  struct Level {
    Group group;
    Node stop;                // where it is gathered ...
    std::size_t gathered_by;  // ... by the level of this index
  };
  const std::vector<Node>& post_dominators_;
  Node end_;
  std::vector<Level> stack_;
};

}  // namespace

Policy::Policy(const Flow& flow, std::string_view name)
    : join_(flow.end()), post_dominators_(flow.nearest_post_dominators(nullptr)), end_(flow.end()) {
  if (name == "ipdom") return;
  if (name != "loop_postdom" && name != "min_pc") throw std::logic_error("no such policy");
  rank_.assign(flow.end(), flow.end());
  const std::vector<Node> order = flow.loop_contiguous_order();
  for (std::uint32_t i = 0; i < order.size(); ++i) rank_[order[i]] = i;
  if (name == "min_pc") join_.assign(flow.end(), true);
  const auto mark = [&](const std::vector<Node>& meetings) {
    for (Node node = 0; node < flow.end(); ++node)
      if (flow.stretches()[node].to.size() > 1 && meetings[node] != end_) join_[meetings[node]] = true;
  };
  mark(post_dominators_);
  for (const Loop& loop : flow.loops()) {
    join_[loop.header] = true;
    mark(flow.nearest_post_dominators(&loop));
  }
}

std::unique_ptr<Schedule> Policy::schedule(Lanes lanes) const {
  if (rank_.empty()) return std::make_unique<GatheringSchedule>(lanes, post_dominators_, end_);
  return std::make_unique<RankedSchedule>(lanes, rank_, join_);
}

}  // namespace warpgrain::oracle
