#pragma once
// The counters of a profiled launch: plain numbers, in the names of the report "warpgrain.report/1".

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "profiler/diagnostic.hpp"
#include "profiler/kernel_graph.hpp"
#include "profiler/launch.hpp"
#include "profiler/timeline.hpp"
#include "profiler/touched_memory.hpp"

namespace warpgrain::profiler {

// Of one kind of memory access, summed over warps. Generic accesses, whose space only shows as they run,
// count as global.
struct MemoryCounters {
  std::uint64_t requests = 0;      // warp-level requests
  std::uint64_t sectors = 0;       // 32-byte sectors touched
  std::uint64_t lines = 0;         // 128-byte lines touched
  std::uint64_t useful_bytes = 0;  // bytes that lanes asked for

  double sectors_per_request() const;  // 0 without requests, as the next two
  double lines_per_request() const;
  // Useful bytes over those of the sectors. Lanes that read the same bytes count each, so it can exceed 1.
  double efficiency() const;
  void add(const MemoryCounters& other);
  bool operator==(const MemoryCounters&) const = default;
};

// Distinct 32-byte sectors of the launch's buffers: what caches would have to fetch and write back, were they
// large enough. Atomics are neither loads nor stores.
struct FootprintCounters {
  std::uint64_t group_load_sectors = 0, group_store_sectors = 0;  // of each work-group, summed over them
  std::uint64_t load_sectors = 0, store_sectors = 0;              // of the whole launch
  std::uint64_t part_stored_sectors = 0;  // of these, those of which some bytes are never stored
  std::uint64_t sectors = 0;              // loaded or stored
  bool operator==(const FootprintCounters&) const = default;
};

struct InstructionCount {
  std::uint64_t warp = 0;    // issued, one a warp
  std::uint64_t thread = 0;  // the same, counted per active lane
  bool operator==(const InstructionCount&) const = default;
};

struct Totals {
  std::uint64_t warp_instructions = 0;
  std::uint64_t thread_instructions = 0;
  // Of these, lanes whose predicate was true; 0: not counted, which only the replay of machine code does.
  std::uint64_t thread_instructions_pred_on = 0;
  std::vector<std::uint64_t> lane_histogram;  // [warp_width + 1]: warp instructions by number of active lanes
  std::uint64_t branches = 0;                 // conditional branches, counted per warp
  std::uint64_t divergent_branches = 0;       // those whose lanes disagreed
  std::uint64_t sfu_instructions = 0;         // warp instructions on the special-function unit
  std::array<InstructionCount, n_instruction_classes> instruction_mix{};
  MemoryCounters global_load, global_store, shared_load, shared_store, atomic;

  double active_lanes() const;  // thread_instructions / warp_instructions; 0 when none
  double simt_efficiency(std::uint32_t warp_width) const;  // active_lanes / warp_width
  // Lane slots (a lane of an issued warp instruction) without a lane: warp_width * warp_instructions -
  // thread_instructions.
  std::uint64_t lane_slots_idle(std::uint32_t warp_width) const;
  void add(const Totals& other);  // element by element, of the same warp width
  bool operator==(const Totals&) const = default;
};

// The lines sum up to the launch's totals; instructions that the compiler gave no line count under file "",
// line 0.
struct LineTotals {
  std::string file;
  std::uint32_t line = 0;
  Totals totals;
};

struct BlockTotals {
  std::uint32_t block = 0;  // index into KernelGraph::blocks
  std::string label;
  std::uint64_t instructions = 0;  // in it
  std::uint64_t executions = 0;
  std::uint64_t divergent = 0;                // of these, lanes went different ways from it
  std::vector<std::uint64_t> lane_histogram;  // executions by number of active lanes, [warp_width + 1]
  std::string file;                           // of its first instruction with a place; empty: none has
  std::uint32_t line = 0;                     // the same; 0: none

  std::uint64_t lane_slots_idle() const;  // while it ran
};

// A conditional branch of the PTX.
struct BranchTotals {
  std::string file;
  std::uint32_t line = 0;
  std::string label;  // `// branch: NAME` at the end of the source line, else the line's text
  std::uint32_t block = 0;
  std::uint64_t executions = 0;   // per warp
  std::uint64_t divergent = 0;    // of these, lanes disagreed
  std::uint64_t lanes = 0;        // lanes that executed it
  std::uint64_t taken_lanes = 0;  // of these, took the first successor
  // Lane slots (a lane of an issued warp instruction) in which a lane idled because this branch had parted it
  // from the lanes that ran. The sum over branches plus `lane_slots_never_used` is width * warp_instructions
  // - thread_instructions.
  std::uint64_t lane_slots_lost = 0;
};

// What the launch would have counted with other warps. profiler/what_if.hpp defines the questions.
struct WhatIfTotals {
  std::uint32_t warp_width = 32;
  std::string policy;      // none for a pool
  std::string order;       // of the threads: "launched", "shuffled:1", "sorted:thread_instructions"
  std::uint32_t pool = 0;  // threads of which warps are formed anew at each block; 0: warps stay as they are
  std::uint64_t warps = 0;
  // Of a pool: instructions, SFU instructions and the instruction mix; the rest is zero.
  Totals totals;
  bool has_requests = false;  // whether memory requests were counted: in the launched order alone
  std::string remark;         // what to know of this answer; mostly none
  bool operator==(const WhatIfTotals&) const = default;
};

// A piece of memory that a kernel is given.
struct BufferExtent {
  std::uint64_t address = 0, bytes = 0;
  bool operator==(const BufferExtent&) const = default;
};

// What an instruction is in the counts.
struct WeightsUsed {
  bool sass = false;            // those of the machine code, replayed; else those of the PTX
  bool asked = false;           // whether the machine code was asked for
  std::string arch, ptxas;      // what it was assembled for, and the version that did
  std::string reason;           // why those of the PTX, where others were asked for
  std::uint64_t underived = 0;  // choices of lanes and warps that the traces do not tell: then the PTX counts
  std::uint64_t registers = 0;  // of a lane, as ptxas gave them; 0: not known
  // Choices of lanes that were taken not to need the routines for rare operands (of a division, say).
  std::uint64_t fast_paths = 0;
  // Accesses of the PTX whose requests are those of its merged lanes, since the machine code's could not be
  // followed.
  std::uint64_t requests_of_ptx = 0;
  // Of the thread instructions, those under a predicate that nothing in the trace tells.
  std::uint64_t predicates_assumed = 0;
  // How often YIELD made another group of a warp run, by a rule of the machine that is known in part.
  std::uint64_t turns_assumed = 0;
  // How often the trips that a lane had left would have let it go either way, and it took that with more
  // copies of an unrolled loop's body.
  std::uint64_t trips_assumed = 0;
  bool operator==(const WeightsUsed&) const = default;
};

struct LaunchCounters {
  std::string kernel;
  LaunchShape shape;
  std::uint64_t shared_bytes = 0;  // of a work-group
  std::vector<BufferExtent> buffers;
  std::uint32_t warp_width = 32;
  std::string policy;
  std::uint64_t warps = 0;
  WeightsUsed weights;  // of totals, lines and branches; blocks are those of the PTX
  Totals totals;
  std::optional<FootprintCounters> footprint;  // where it was asked for
  std::vector<LineTotals> lines;               // sorted by file, line
  std::vector<BlockTotals> blocks;             // every block, in order
  std::vector<BranchTotals> branches;          // by lane_slots_lost, largest first
  std::uint64_t lane_slots_never_used = 0;     // warps that are not full from the start
  std::vector<WhatIfTotals> what_if;           // in the order of the questions
  std::vector<WarpTimeline> timelines;         // of the warps that were asked for
  std::vector<WarpSums> warp_sums;             // of every warp by number; not part of reports
  TouchedMemory touched;                       // with a footprint, atomics too; not part of reports
  std::vector<Diagnostic> diagnostics;         // what is wrong with the kernel, by its PTX
  bool given_up = false;  // too many work-items had to be stopped: not all work-groups ran
};

}  // namespace warpgrain::profiler
