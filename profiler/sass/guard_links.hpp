#pragma once
// Which decision of the PTX a guard of the machine code carries out, and which way around.

#include <cstdint>
#include <vector>

#include "profiler/sass/code_graph.hpp"
#include "profiler/sass/ptx_decisions.hpp"

namespace warpgrain::profiler::sass {

struct GuardLink {
  enum class Kind : std::uint8_t {
    decision,   // lanes that take the guard are those whose decision went to `taken_way` of the successors
    fast_path,  // skips, or makes, a call of a routine for rare operands that the assembler adds
    unknown     // no decision of the PTX stands for it
  };
  Kind kind = Kind::unknown;
  // The decision near which the guard stands, of an unknown one, too; no_decision if there is none.
  std::uint32_t decision = no_decision;
  std::uint32_t taken_way = 0;   // index into BasicBlock::successors
  bool fast_path_taken = false;  // whether the fast path is that of the lanes that take the guard
};

// [blocks of the code]; of those that end in an indirect branch only `decision` is meant, of others nothing.
//
// The line of a guard names the branch, or an instruction of the block before it. Which way is taken follows
// from what comes behind: instructions of blocks that only one way of the decision leads to.
std::vector<GuardLink> link_guards(const CodeGraph& code, const PtxDecisions& decisions);

}  // namespace warpgrain::profiler::sass
