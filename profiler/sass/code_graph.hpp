#pragma once
// Machine code cut into basic blocks, with what each does to the masks of lanes that are to meet.

#include <cstdint>
#include <vector>

#include "profiler/sass/cubin.hpp"
#include "profiler/sass/instruction.hpp"

namespace warpgrain::profiler::sass {

inline constexpr std::uint32_t no_code = 0xFFFFFFFF;

enum class End : std::uint8_t {
  next,       // goes on with the block behind it, or to `target`
  guard,      // some lanes do what the last instruction says, the others go on with `next`
  indirect,   // to one of `table`
  call,       // to `target`, and comes back to `next`
  ret,        // from a call
  exit,       // the lane ends
  meet,       // waits for the lanes of `barrier`
  warp_meet,  // waits for the lanes of the warp
  yield,      // lets others run first
};

// Whether what follows is `next` for all lanes.
constexpr bool goes_on(End end) {
  return end == End::next || end == End::meet || end == End::warp_meet || end == End::yield;
}

// Something done to a barrier's mask before the block ends.
struct MaskAction {
  enum class Lanes : std::uint8_t { all, taken, not_taken };  // of BREAK: which of those that end the block
  Flow flow = Flow::open;                                     // open, leave, save or restore
  std::uint8_t barrier = 0;
  std::uint8_t reg = 0;
  Lanes lanes = Lanes::all;
};

struct CodeBlock {
  std::uint32_t first = 0, last = 0;  // instructions [first, last)
  End end = End::next;
  // A guard's: what lanes do that take it: branch, call, ret or exit.
  Flow guarded = Flow::none;
  std::uint32_t next = no_code;    // what follows for lanes that do not jump
  std::uint32_t target = no_code;  // where a guard's lanes, or all of a call, go
  std::uint8_t barrier = 0;
  bool if_divergent = false;  // a guard that warps take whose lanes have parted
  std::vector<MaskAction> actions;
  std::vector<std::uint32_t> table;  // where an indirect branch can go, in the order of its table, each once
};

struct CodeGraph {
  std::vector<Instruction> instructions;
  std::vector<CodeBlock> blocks;  // [0] is the entry; by address

  const Instruction& last_of(const CodeBlock& block) const { return instructions[block.last - 1]; }
};

// Throws InputError for a branch out of the kernel's code and for an indirect call.
CodeGraph cut_code(const KernelCode& code, unsigned sm);

}  // namespace warpgrain::profiler::sass
