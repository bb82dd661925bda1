#pragma once
// Replays a launch of a kernel and keeps both sides: what the trace says of the PTX, what the replay says of
// the machine code.

#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "profiler/merge.hpp"
#include "profiler/sass/machine_kernel.hpp"
#include "profiler/sass/replay_check.hpp"
#include "profiler/sass/warp_replayer.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler::sass {

inline constexpr const char* no_ptxas = "ptxas is not installed";

class ReplayedKernel {
 public:
  ReplayedKernel(const std::string& source, const std::string& name, const LaunchShape& shape,
                 const std::vector<KernelArgument>& arguments, const std::string& arch = "sm_90")
      : executable_(compile_kernel(source, name, TraceMode::blocks_and_addresses)),
        kernel_(assemble_kernel(*find_ptxas(), executable_->ptx(), executable_->graph(), arch)),
        replay_(kernel_->code, kernel_->plan, executable_->graph()),
        of_ptx_(executable_->graph(), replayed_warp_width) {
    const auto replayer = make_warp_replayer(kernel_->code, kernel_->plan, kernel_->decisions, replay_);
    const auto merger = make_counting_merger(executable_->graph(), MergePolicy::loop_postdom, of_ptx_);
    const auto runner = executable_->runner(shape, arguments);
    for (std::uint64_t group = 0; group < shape.group_count()[0]; ++group) {
      const std::span<const LaneTrace> lanes = runner->run({group, 0, 0});
      merge_warps(*merger, lanes, replayed_warp_width);
      for (std::size_t first = 0; first < lanes.size(); first += replayed_warp_width)
        replayer->replay(
            lanes.subspan(first, std::min<std::size_t>(replayed_warp_width, lanes.size() - first)));
    }
  }

  const MachineKernel& kernel() const { return *kernel_; }
  const ReplayCounters& replay() const { return replay_; }
  const WarpCounters& of_ptx() const { return of_ptx_; }

  // How often warps, and lanes, issued instructions of that name that no predicate can switch off.
  std::uint64_t warps_at(std::string_view name) const { return sum(name, false); }
  std::uint64_t lanes_at(std::string_view name) const { return sum(name, true); }
  // How many guards follow a rule.
  std::size_t nodes(Rule rule) const {
    std::size_t count = 0;
    for (const Node& node : kernel_->plan.nodes)
      if (&node != &kernel_->plan.nodes.back() && node.rule == rule) ++count;
    return count;
  }
  std::uint64_t divergent() const {
    std::uint64_t count = 0;
    for (const std::uint64_t of_block : replay_.divergent) count += of_block;
    return count;
  }

  // Everything could be derived, and what has an effect happened as often as in the trace.
  void expect_complete() const {
    EXPECT_EQ(replay_.unresolved(), 0U);
    EXPECT_EQ(contradictions(*kernel_, replay_, of_ptx_), std::vector<std::string>{});
  }

 private:
  std::uint64_t sum(std::string_view name, bool lanes) const {
    std::uint64_t count = 0;
    for (std::uint32_t b = 0; b < kernel_->code.blocks.size(); ++b)
      for (std::uint32_t k = kernel_->code.blocks[b].first; k < kernel_->code.blocks[b].last; ++k) {
        const Instruction& instruction = kernel_->code.instructions[k];
        if (mnemonic(instruction) != name || instruction.is_conditional()) continue;
        const auto executions = replay_.executions(b);
        for (std::size_t n = 0; n < executions.size(); ++n) count += executions[n] * (lanes ? n : 1);
      }
    return count;
  }

  std::unique_ptr<Executable> executable_;
  std::unique_ptr<MachineKernel> kernel_;
  ReplayCounters replay_;
  WarpCounters of_ptx_;
};

}  // namespace warpgrain::profiler::sass
