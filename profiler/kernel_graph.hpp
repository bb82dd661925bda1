#pragma once
// A kernel as the warp sees it: PTX basic blocks, what is in them, and where they lead. Plain data: the
// translator makes it, the merger and the observers read it.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace warpgrain::profiler {

// Classes of the instruction mix. `instruction_class_name` gives the spelling in reports.
enum class InstructionClass : std::uint8_t {
  fp32,
  fp64,
  fp16,
  integer,
  special_function,
  conversion,
  predicate,
  move,
  parameter_load,
  constant_load,
  global_load,
  global_store,
  shared_load,
  shared_store,
  local_load,
  local_store,
  generic_load,
  generic_store,
  atomic,
  branch,
  barrier,
  warp_level,
  fence,
  exit,
  other,
  count
};
inline constexpr std::size_t n_instruction_classes = static_cast<std::size_t>(InstructionClass::count);
std::string_view instruction_class_name(InstructionClass c);

struct SourceLocation {
  std::uint32_t file = 0;  // index into KernelGraph::files
  std::uint32_t line = 0;  // from 1; 0: the compiler gave none
  bool operator==(const SourceLocation&) const = default;
};

struct Instruction {
  InstructionClass instruction_class = InstructionClass::other;
  // How often issuing it uses the special-function unit (MUFU and conversions): 0 or 1 for most, more for
  // what ptxas expands (an integer division converts and takes a reciprocal).
  std::uint8_t sfu_operations = 0;
  SourceLocation location;
  std::string text;            // PTX, as it stands in the module
  std::uint32_t ptx_line = 0;  // where, from 1
};

// One address that a lane records when it runs the block, in the order of execution. Only global, shared,
// generic and atomic accesses are recorded; parameters, constants and local memory are not. Beside them the
// path that a division of doubles takes (sass/recorded_paths.hpp), as an access of 0 bytes.
struct MemoryAccess {
  std::uint32_t instruction = 0;  // index into BasicBlock::instructions
  InstructionClass access = InstructionClass::global_load;
  std::uint8_t bytes = 0;  // a lane's, vector width included
};

struct BasicBlock {
  std::string label;
  std::vector<Instruction> instructions;
  std::vector<MemoryAccess> accesses;
  // Indices into KernelGraph::blocks. Of a conditional branch: taken, then fall-through; of brx: its table,
  // duplicates dropped; empty: the lane ends here.
  std::vector<std::uint32_t> successors;
  // Whether running the block appends its index to the lane's trace: the entry, and every block that some
  // predecessor with more than one successor leads to. The others follow from the block before them.
  bool recorded = true;
};

struct KernelGraph {
  std::string kernel;
  std::string entry;               // its name in the PTX
  std::vector<std::string> files;  // as .file directives name them
  std::vector<BasicBlock> blocks;  // [0] is the entry; in the order of the PTX text
  std::uint32_t shared_bytes = 0;  // static shared (__local) memory of a work-group
  bool has_barrier = false;
  bool has_warp_level = false;  // operations between the lanes of a warp
};

}  // namespace warpgrain::profiler
