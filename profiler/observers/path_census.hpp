#pragma once
// Which paths lanes take through the bodies of a kernel's loops, against the 2^N that N branches allow.
//
// A path of a loop is the sequence of blocks that a lane runs from the loop's first block until it comes
// there again or leaves; blocks of loops inside it count to those. What stands outside of all loops is one
// more body, which a lane runs once.

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "profiler/control_flow.hpp"
#include "profiler/observers/warp_observer.hpp"

namespace warpgrain::profiler {

struct LoopPaths {
  std::string kernel;
  std::string file;                // of the loop's first instruction with a place; empty: none
  std::uint32_t line = 0;          // the same; 0: none
  bool is_loop = true;             // else what stands outside of all loops
  std::uint32_t branches = 0;      // conditional ones of the body, loops inside it apart
  std::uint64_t passes = 0;        // of lanes
  std::uint64_t instructions = 0;  // that lanes ran in it
  std::uint64_t paths = 0;         // different ones
};

// One thread tells it what happens. Launches of one kernel add up.
class PathCensus : public WarpObserver {
 public:
  void launch_begins(const KernelGraph& graph) override;
  void warp_begins(std::uint64_t lanes) override;
  void block_issued(const LaneGroup& group, std::span<const std::uint64_t* const> addresses) override;

  // Of all launches, in their order; bodies that no lane ran are left out. Ends the passes that are under
  // way.
  std::vector<LoopPaths> bodies();

 private:
  static constexpr std::size_t max_lanes = 64;
  struct Body {
    LoopPaths facts;
    std::unordered_map<std::uint64_t, std::uint64_t> passes_of;  // by a hash of the path
    std::uint64_t hash[max_lanes] = {};                          // of the path under way; 0: none is
  };
  struct Kernel {
    std::string name;
    std::vector<std::uint32_t> loop_of;       // [blocks]: index into bodies
    std::vector<std::uint32_t> parent;        // [bodies]: the body around it; its own: none
    std::vector<std::uint32_t> header;        // [bodies]
    std::vector<std::uint32_t> instructions;  // [blocks]
    std::vector<Body> bodies;                 // the loops, then what is outside
  };

  void end_pass(Body& body, std::size_t lane);
  void end_all();

  std::vector<Kernel> kernels_;
  std::size_t current_ = 0;
  std::uint32_t body_of_lane_[max_lanes] = {};
};

}  // namespace warpgrain::profiler
