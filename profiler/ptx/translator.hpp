#pragma once
// A kernel's PTX -> one LLVM function `void (LaneContext*)` that runs one lane and leaves its trace. One LLVM
// block begins each PTX block, and the edges between them are the same.

#include <llvm/IR/Module.h>
#include <span>
#include <string_view>

#include "profiler/access_site.hpp"
#include "profiler/executable.hpp"
#include "profiler/ptx/control_flow.hpp"
#include "profiler/ptx/memory_layout.hpp"
#include "profiler/ptx/module.hpp"

namespace warpgrain::profiler::ptx {

inline constexpr std::string_view lane_function_name = "warpgrain_lane";
// Addresses of the module's variables, in order of MemoryObject::offset; null: the code does not use it.
inline constexpr std::string_view variable_list_name = "warpgrain_variables";

// What is emitted around the kernel's own instructions.
struct Instrumentation {
  TraceMode mode = TraceMode::blocks;
  Checks checks = Checks::off;
  // Instructions that a pass through a block from which a loop begins again takes from the lane's budget,
  // [blocks].
  std::vector<std::uint32_t> loop_costs;
};

// Adds the function to `out`, and with checks the list of variables. `kernel` is an entry without calls.
// What is to be known of the accesses that are checked; nothing when none are. Throws InputError for what is
// not carried.
MemoryFacts translate(const Module& module, const Function& kernel, std::span<const Block> blocks,
                      const MemoryLayout& layout, const Instrumentation& instrumentation,
                      std::string_view where, llvm::Module& out);

}  // namespace warpgrain::profiler::ptx
