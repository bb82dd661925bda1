#include "profiler/merge_policy.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "profiler/control_flow.hpp"
#include "profiler/reconvergence.hpp"

namespace warpgrain::profiler {
namespace {

constexpr std::array<std::string_view, 3> policy_names{"loop_postdom", "ipdom", "min_pc"};

// loop_postdom and min_pc, which differ in their joins alone.
class LowestFirst : public WarpSchedule {
 public:
  LowestFirst(std::vector<std::uint32_t> rank, std::vector<bool> join)
      : rank_(std::move(rank)), join_(std::move(join)) {}

  void start(std::uint64_t lanes) override { waiting_ = {{0, lanes}}; }

  std::optional<LaneGroup> next() override {
    if (waiting_.empty()) return std::nullopt;
    // Of groups at the same block that do not join, the one that came last goes on.
    const auto lowest =
        std::min_element(waiting_.rbegin(), waiting_.rend(),
                         [&](const auto& a, const auto& b) { return rank_[a.block] < rank_[b.block]; });
    LaneGroup group = *lowest;
    waiting_.erase(std::next(lowest).base());
    if (join_[group.block])
      std::erase_if(waiting_, [&](const LaneGroup& other) {
        if (other.block != group.block) return false;
        group.lanes |= other.lanes;
        return true;
      });
    return group;
  }

  void advance(std::span<const LaneGroup> parts) override {
    waiting_.insert(waiting_.end(), parts.begin(), parts.end());
  }

 private:
  std::vector<std::uint32_t> rank_;
  std::vector<bool> join_;
  std::vector<LaneGroup> waiting_;  // in order of arrival
};

class PostDominatorStack : public WarpSchedule {
 public:
  explicit PostDominatorStack(std::vector<std::uint32_t> post_dominator)
      : post_dominator_(std::move(post_dominator)) {}

  void start(std::uint64_t lanes) override { stack_ = {{{0, lanes}, no_block}}; }

  std::optional<LaneGroup> next() override {
    while (!stack_.empty() && stack_.back().group.block == stack_.back().until) stack_.pop_back();
    if (stack_.empty()) return std::nullopt;
    return stack_.back().group;
  }

  void advance(std::span<const LaneGroup> parts) override {
    Entry& ran = stack_.back();
    const std::uint32_t from = ran.group.block;
    std::uint64_t going_on = 0;
    for (const LaneGroup& part : parts) going_on |= part.lanes;
    if (going_on == 0) {
      stack_.pop_back();
    } else if (parts.size() == 1 && going_on == ran.group.lanes) {
      ran.group.block = parts[0].block;
    } else {
      // All that go on wait at the post-dominator, below the parts that are still on their way to it.
      const std::uint32_t meeting = post_dominator_[from];
      ran.group = {meeting, going_on};
      if (meeting == no_block) stack_.pop_back();
      for (const LaneGroup& part : parts)
        if (part.block != meeting) stack_.push_back({part, meeting});
    }
  }

 private:
  struct Entry {
    LaneGroup group;
    std::uint32_t until;  // the block at which it waits for the others
  };
  std::vector<std::uint32_t> post_dominator_;
  std::vector<Entry> stack_;
};

}  // namespace

std::string_view merge_policy_name(MergePolicy policy) {
  return policy_names[static_cast<std::size_t>(policy)];
}

MergePolicy merge_policy_from_name(std::string_view name, std::string_view where) {
  const auto found = std::find(policy_names.begin(), policy_names.end(), name);
  if (found == policy_names.end()) throw_unknown_name(where, "merge policy", name, policy_names);
  return static_cast<MergePolicy>(found - policy_names.begin());
}

std::unique_ptr<WarpSchedule> make_warp_schedule(MergePolicy policy, const KernelGraph& graph) {
  Reconvergence reconvergence = find_reconvergence(graph);
  switch (policy) {
    case MergePolicy::loop_postdom:
      return std::make_unique<LowestFirst>(std::move(reconvergence.rank), std::move(reconvergence.join));
    case MergePolicy::ipdom:
      return std::make_unique<PostDominatorStack>(std::move(reconvergence.immediate_post_dominator));
    case MergePolicy::min_pc:
      break;
  }
  return std::make_unique<LowestFirst>(std::move(reconvergence.rank),
                                       std::vector<bool>(graph.blocks.size(), true));
}

}  // namespace warpgrain::profiler
