#include "profiler/sass/replay_totals.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "profiler/observers/branches.hpp"
#include "profiler/observers/lines.hpp"
#include "profiler/observers/totals.hpp"
#include "profiler/sass/predicated_lanes.hpp"

namespace warpgrain::profiler::sass {
namespace {

// What ncu counts as a branch: jumps, calls and returns with or without a condition, but no EXIT.
bool is_jump(const Instruction& instruction) {
  switch (instruction.flow) {
    case Flow::branch:
    case Flow::indirect_branch:
    case Flow::call:
    case Flow::ret:
      return true;
    default:
      return false;
  }
}

class Summing {
 public:
  Summing(const MachineKernel& kernel, const ReplayCounters& counters, const WarpCounters& of_ptx)
      : kernel_(kernel), counters_(counters), predicated_(count_predicated(kernel, counters, of_ptx)) {}

  std::uint64_t predicates_assumed() const { return predicated_.assumed; }

  // Adds one instruction of a block.
  void add(std::uint32_t b, std::uint32_t k, Totals& totals) const {
    const CodeBlock& block = kernel_.code.blocks[b];
    const Instruction& instruction = kernel_.code.instructions[k];
    const auto executions = counters_.executions(b), again = counters_.again(b);
    const bool is_last = k + 1 == block.last;
    std::uint64_t warps = 0, threads = 0;
    for (std::size_t lanes = 0; lanes < executions.size(); ++lanes) {
      const std::uint64_t issued = executions[lanes] + (is_last ? again[lanes] : 0);
      warps += issued;
      threads += issued * lanes;
      totals.lane_histogram[lanes] += issued;
    }
    totals.warp_instructions += warps;
    totals.thread_instructions += threads;
    totals.thread_instructions_pred_on += predicated_.on[k];
    if (instruction.special_function) totals.sfu_instructions += warps;
    InstructionCount& mix = totals.instruction_mix[static_cast<std::size_t>(instruction.instruction_class)];
    mix.warp += warps;
    mix.thread += threads;
    if (!is_last || !is_jump(instruction)) return;
    totals.branches += warps;
    if (block.end != End::indirect) {
      totals.divergent_branches += counters_.divergent[b];
      return;
    }
    // Where an indirect branch goes k ways, k - 1 of its issues part lanes, and the last is no branch.
    totals.branches -= counters_.divergent[b];
    for (const std::uint64_t issues : again) totals.divergent_branches += issues;
  }

 private:
  const MachineKernel& kernel_;
  const ReplayCounters& counters_;
  PredicatedLanes predicated_;
};

void keep_requests(const Totals& from, Totals& to) {
  to.global_load = from.global_load;
  to.global_store = from.global_store;
  to.shared_load = from.shared_load;
  to.shared_store = from.shared_store;
  to.atomic = from.atomic;
}

// The sums of the merged lanes with the requests of the replay: at the first access of each stream those of
// all, at the others none. A stream whose accesses did not match stays as it was, and so do those whose
// instructions it shares.
WarpCounters with_replayed_requests(const MachineKernel& kernel, const RequestCounters& replayed,
                                    const WarpCounters& of_ptx, WeightsUsed& weights) {
  const MemorySites& memory = kernel.plan.memory;
  const auto follows = [&](std::uint32_t s) {
    if (replayed.unmatched[s] != 0) return false;
    for (const std::uint32_t other : memory.streams[s].without_site)
      if (replayed.unmatched[other] != 0 && replayed.borrowed[other] != 0) return false;
    return true;
  };
  WarpCounters result = of_ptx;
  std::vector<bool> placed(memory.streams.size(), false);
  for (std::uint32_t b = 0; b < memory.of_access.size(); ++b)
    for (std::uint32_t k = 0; k < memory.of_access[b].size(); ++k) {
      const std::uint32_t s = memory.of_access[b][k];
      if (s == no_stream) continue;
      if (!follows(s)) {
        weights.requests_of_ptx += placed[s] ? 0 : 1;
      } else {
        result.accesses[of_ptx.first_access[b] + k] = placed[s] ? MemoryCounters{} : replayed.requests[s];
      }
      placed[s] = true;
    }
  return result;
}

std::vector<LineTotals> lines_of_code(const MachineKernel& kernel, const Summing& summing,
                                      const std::vector<LineTotals>& of_ptx) {
  const KernelGraph& graph = kernel.decisions.graph();
  std::map<std::pair<std::string, std::uint32_t>, Totals> lines;
  const auto at = [&](const std::string& file, std::uint32_t line) -> Totals& {
    return lines.try_emplace({file, line}, empty_totals(replayed_warp_width)).first->second;
  };
  for (const LineTotals& line : of_ptx) keep_requests(line.totals, at(line.file, line.line));
  for (std::uint32_t b = 0; b < kernel.code.blocks.size(); ++b)
    for (std::uint32_t k = kernel.code.blocks[b].first; k < kernel.code.blocks[b].last; ++k) {
      const auto& places = kernel.decisions.places(kernel.code.instructions[k].line);
      SourceLocation location;
      if (!places.empty())
        location = graph.blocks[places[0].block].instructions[places[0].instruction].location;
      summing.add(b, k, location.line == 0 ? at("", 0) : at(graph.files[location.file], location.line));
    }
  std::vector<LineTotals> result;
  for (auto& [place, totals] : lines)
    if (totals.warp_instructions != 0) result.push_back({place.first, place.second, std::move(totals)});
  return result;
}

// A decision of the PTX that no guard carries out is no branch any more.
std::vector<BranchTotals> branch_totals(const MachineKernel& kernel, const ReplayCounters& counters,
                                        const SourceLines& source) {
  const KernelGraph& graph = kernel.decisions.graph();
  std::map<std::uint32_t, BranchTotals> branches;  // by decision
  for (const Node& node : kernel.plan.nodes) {
    if (node.decision == no_decision || node.rule == Rule::fast_path) continue;
    BranchTotals& branch = branches[node.decision];
    const auto executions = counters.executions(node.block);
    std::uint64_t lanes_here = 0;
    for (std::size_t lanes = 0; lanes < executions.size(); ++lanes) {
      branch.executions += executions[lanes];
      lanes_here += executions[lanes] * lanes;
    }
    branch.lanes += lanes_here;
    branch.divergent += counters.divergent[node.block];
    const std::uint64_t taken = counters.taken_lanes[node.block];
    branch.taken_lanes += node.taken_way == 0 ? taken : lanes_here - taken;
  }
  std::vector<BranchTotals> result;
  for (auto& [decision, branch] : branches) {
    if (branch.executions == 0) continue;
    branch.block = kernel.decisions.blocks_of(decision)[0];
    const BasicBlock& block = graph.blocks[branch.block];
    const SourceLocation location = block.instructions[branch_instruction(block)].location;
    if (location.line != 0) {
      branch.file = graph.files[location.file];
      branch.line = location.line;
    }
    branch.label = branch_label(graph, branch.block, source);
    branch.lane_slots_lost = counters.lane_slots_lost[branch.block];
    result.push_back(std::move(branch));
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return a.lane_slots_lost != b.lane_slots_lost ? a.lane_slots_lost > b.lane_slots_lost : a.block < b.block;
  });
  return result;
}

}  // namespace

void put_replay(const MachineKernel& kernel, const ReplayCounters& counters, const WarpCounters& of_ptx,
                const SourceLines& source, LaunchCounters& launch) {
  const KernelGraph& graph = kernel.decisions.graph();
  const WarpCounters requests = with_replayed_requests(kernel, counters.requests, of_ptx, launch.weights);
  launch.totals = launch_totals(graph, requests);
  launch.lines = line_totals(graph, requests);
  const Summing summing(kernel, counters, of_ptx);
  launch.weights.predicates_assumed = summing.predicates_assumed();
  Totals totals = empty_totals(replayed_warp_width);
  keep_requests(launch.totals, totals);
  for (std::uint32_t b = 0; b < kernel.code.blocks.size(); ++b)
    for (std::uint32_t k = kernel.code.blocks[b].first; k < kernel.code.blocks[b].last; ++k)
      summing.add(b, k, totals);
  launch.totals = std::move(totals);
  launch.lines = lines_of_code(kernel, summing, launch.lines);
  launch.branches = branch_totals(kernel, counters, source);
  launch.lane_slots_never_used = counters.lane_slots_lost[counters.never_used()];
}

}  // namespace warpgrain::profiler::sass
