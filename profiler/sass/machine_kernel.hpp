#pragma once
// A kernel as ptxas assembles it, ready to be replayed.

#include <memory>
#include <string>
#include <string_view>

#include "profiler/kernel_graph.hpp"
#include "profiler/sass/code_graph.hpp"
#include "profiler/sass/cubin.hpp"
#include "profiler/sass/ptx_decisions.hpp"
#include "profiler/sass/ptxas.hpp"
#include "profiler/sass/replay_plan.hpp"

namespace warpgrain::profiler::sass {

struct MachineKernel {
  MachineKernel(CodeGraph machine_code, const KernelGraph& graph, std::uint32_t n_registers);

  std::uint32_t registers;  // of a lane; 0 where the assembler does not say
  CodeGraph code;
  PtxDecisions decisions;
  ReplayPlan plan;
};

// "sm_90" -> 90. Throws InputError for what is no such name, and for architectures whose instructions are not
// 128 bits long (before sm_75) or not known (after sm_90).
unsigned architecture_number(std::string_view arch);

// Throws InputError unless the machine code that was assembled with lines is, byte by byte, what a GPU would
// run. `auto` weights are the PTX's then, and the report says why.
void require_same_code(const KernelCode& with_lines, const KernelCode& plain, const std::string& kernel);

// Assembles the module, with lines and without, and makes sure that the machine code is the same; the last
// few modules are kept. Throws InputError where ptxas does not take the module, or the code cannot be
// replayed. `graph`, of the kernel in that module, outlives the result.
std::unique_ptr<MachineKernel> assemble_kernel(const Ptxas& ptxas, std::string_view ptx,
                                               const KernelGraph& graph, std::string_view arch);

}  // namespace warpgrain::profiler::sass
