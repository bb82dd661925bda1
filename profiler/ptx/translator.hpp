#pragma once
// A kernel's PTX -> one LLVM function `void (LaneContext*)` that runs one lane and leaves its trace. One LLVM
// block begins each PTX block, and the edges between them are the same.

#include <llvm/IR/Module.h>
#include <span>
#include <string_view>

#include "profiler/executable.hpp"
#include "profiler/ptx/control_flow.hpp"
#include "profiler/ptx/memory_layout.hpp"
#include "profiler/ptx/module.hpp"

namespace warpgrain::profiler::ptx {

inline constexpr std::string_view lane_function_name = "warpgrain_lane";

// Adds the function to `out`. `kernel` is an entry without calls. Throws InputError for what is not carried.
void translate(const Module& module, const Function& kernel, std::span<const Block> blocks,
               const MemoryLayout& layout, TraceMode mode, std::string_view where, llvm::Module& out);

}  // namespace warpgrain::profiler::ptx
