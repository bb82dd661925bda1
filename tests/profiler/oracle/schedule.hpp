#pragma once
// Which lanes of a warp run next, under the three policies of profiler/merge_policy.hpp.

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "tests/profiler/oracle/flow.hpp"

namespace warpgrain::oracle {

using Lanes = std::uint64_t;  // bit l is lane l

struct Group {
  Node at = 0;
  Lanes lanes = 0;
};

class Schedule {
 public:
  virtual ~Schedule() = default;
  // The group that runs its stretch now. Nothing when all lanes have ended.
  virtual std::optional<Group> next() = 0;
  // Where the lanes of that group went, those that ended left out.
  virtual void went(const std::vector<Group>& parts) = 0;
};

// What a policy needs to know of a kernel, found once.
class Policy {
 public:
  // loop_postdom, ipdom or min_pc.
  Policy(const Flow& flow, std::string_view name);
  // For a warp whose `lanes` begin at stretch 0.
  std::unique_ptr<Schedule> schedule(Lanes lanes) const;

 private:
  std::vector<std::uint32_t> rank_;    // [stretches]; empty for ipdom
  std::vector<bool> join_;             // [stretches]: whether groups that meet there become one
  std::vector<Node> post_dominators_;  // [stretches]
  Node end_;
};

}  // namespace warpgrain::oracle
