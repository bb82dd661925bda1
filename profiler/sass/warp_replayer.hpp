#pragma once
// Replays warps over the machine code's flow of control: which lanes issue which block together.
//
// A BSYNC is issued once for each group that comes, and again with those that wait at it, where others stand
// there or let them go; an indirect branch once for each way that some lanes go, by the lanes that are left
// (warp_groups.hpp says which run when). So an H100 counts (docs/exactness.md).

#include <memory>
#include <span>

#include "profiler/kernel_graph.hpp"
#include "profiler/sass/code_graph.hpp"
#include "profiler/sass/ptx_decisions.hpp"
#include "profiler/sass/replay_counters.hpp"
#include "profiler/sass/replay_plan.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler::sass {

// Holds scratch space, so one for each thread.
class WarpReplayer {
 public:
  virtual ~WarpReplayer() = default;
  // `lanes` are the warp's, [1 to 32]; null traces stand for lanes that do not exist.
  virtual void replay(std::span<const LaneTrace> lanes) = 0;
};

// Adds to `counters`, which was made for the same plan. All outlive the replayer.
std::unique_ptr<WarpReplayer> make_warp_replayer(const CodeGraph& code, const ReplayPlan& plan,
                                                 const PtxDecisions& decisions, ReplayCounters& counters);

}  // namespace warpgrain::profiler::sass
