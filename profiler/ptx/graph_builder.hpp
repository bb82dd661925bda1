#pragma once
// Parsed PTX -> KernelGraph.

#include <span>

#include "profiler/kernel_graph.hpp"
#include "profiler/ptx/control_flow.hpp"
#include "profiler/ptx/memory_layout.hpp"

namespace warpgrain::profiler::ptx {

KernelGraph build_graph(const Module& module, const Function& kernel, std::span<const Block> blocks,
                        const MemoryLayout& layout);

}  // namespace warpgrain::profiler::ptx
