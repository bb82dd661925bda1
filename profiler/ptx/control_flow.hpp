#pragma once
// The basic blocks of a kernel's PTX.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "profiler/ptx/module.hpp"

namespace warpgrain::profiler::ptx {

// Statements [first, last) of the function; empty for the end that a predicated `exit` or `ret` leads to.
struct Block {
  std::string label;
  std::size_t first = 0, last = 0;
  std::vector<std::uint32_t> successors;  // as BasicBlock::successors
  bool recorded = true;                   // as BasicBlock::recorded
  bool loop_header = false;               // an edge of the depth-first search leads back to it
};

// Whether the statement ends its block.
bool is_terminator(const Statement& statement);

// Cuts at labels that branches name and behind branches; [0] is the entry. Throws InputError for a label that
// is not there and for more blocks than a trace can tell apart.
std::vector<Block> cut_blocks(const Function& function, std::string_view where);

// The block that begins at a statement or holds it.
std::uint32_t block_at(std::span<const Block> blocks, std::size_t statement);

// Labels that a `bra` or `brx` names, taken target first.
std::vector<std::string> branch_targets(const Function& function, const Statement& statement,
                                        std::string_view where);

}  // namespace warpgrain::profiler::ptx
