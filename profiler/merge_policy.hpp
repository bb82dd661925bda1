#pragma once
// How the lanes of a warp that parted come together again.
//
// A warp issues one instruction for all lanes that stand at the same place. Where lanes disagree on a branch
// they become groups that run one at a time, and the policy says which group runs next and where groups
// become one.
//
//   loop_postdom  The group at the lowest block (loop-contiguous reverse post-order) runs; groups join at the
//   joins of
//                 reconvergence.hpp. Follows ptxas's BSSY/BREAK/BSYNC; the default.
//   ipdom         A stack: lanes that part wait for each other at the immediate post-dominator of the branch.
//   What older
//                 simulators do; too low wherever `break`, `continue` or an early return is.
//   min_pc        The group at the lowest block runs, and groups join wherever they meet: the upper bound.
//
// These three are a bound below, the model, and a bound above.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "profiler/kernel_graph.hpp"

namespace warpgrain::profiler {

enum class MergePolicy : std::uint8_t { loop_postdom, ipdom, min_pc };

std::string_view merge_policy_name(MergePolicy policy);
// Throws InputError with the valid names; `where` names the option.
MergePolicy merge_policy_from_name(std::string_view name, std::string_view where);

// Lanes that stand at the same block; bit l is lane l.
struct LaneGroup {
  std::uint32_t block = 0;
  std::uint64_t lanes = 0;
};

// The groups of one warp under a policy. A warp starts with `start`; then `next` says who runs, and `advance`
// where its lanes went, until `next` has none left.
class WarpSchedule {
 public:
  virtual ~WarpSchedule() = default;
  virtual void start(std::uint64_t lanes) = 0;  // all lanes at the entry, block 0
  virtual std::optional<LaneGroup> next() = 0;
  // The group that `next` gave has run its block; its lanes go on as `parts`, without those that ended.
  virtual void advance(std::span<const LaneGroup> parts) = 0;
};

std::unique_ptr<WarpSchedule> make_warp_schedule(MergePolicy policy, const KernelGraph& graph);

}  // namespace warpgrain::profiler
