#pragma once
// A machine instruction of sm_75 to sm_90, as far as replaying and counting it needs. NVIDIA documents no
// encoding: positions of fields were found from what ptxas writes and hold for every listing of nvdisasm
// under tests/profiler/sass/data.

#include <cstdint>
#include <string_view>

#include "profiler/kernel_graph.hpp"

namespace warpgrain::profiler::sass {

// What an instruction does to the flow of control.
enum class Flow : std::uint8_t {
  none,
  branch,           // BRA, to `target`
  indirect_branch,  // BRX, JMX and their kin: to an entry of a table
  call,             // to `target`
  indirect_call,
  ret,
  exit,
  open,       // BSSY: the active lanes will meet at a BSYNC of `barrier`
  meet,       // BSYNC
  leave,      // BREAK: the lanes will not come to the BSYNC of `barrier`
  save,       // BMOV: register `reg` = barrier
  restore,    // BMOV: barrier = register `reg`
  warp_meet,  // WARPSYNC
  yield,      // YIELD: other lanes of the warp run first, and no barrier waits for these meanwhile
};

inline constexpr std::uint32_t instruction_bytes = 16;
inline constexpr std::uint8_t always = 7;             // the predicate that is true, PT
inline constexpr std::uint8_t branch_table_bank = 2;  // the constant bank of the tables of indirect branches
inline constexpr std::uint32_t no_target = 0xFFFFFFFF;

struct Instruction {
  std::uint32_t address = 0;  // in the kernel's code
  std::uint32_t line = 0;     // of the PTX; 0: not known
  // Bits 0 to 11, and in bit 12 bit 91: forms of one operation differ in bits 9 to 11.
  std::uint16_t opcode = 0;
  Flow flow = Flow::none;
  std::uint8_t guard = always;  // the predicate that it runs under
  bool guard_negated = false;
  // Of a branch: a second predicate that it depends on (`BRA P1, target`, or a uniform one), `always` if
  // none.
  std::uint8_t condition = always;
  bool condition_negated = false;
  bool uniform_condition = false;
  bool if_divergent = false;  // BRA.DIV: taken by warps whose lanes have parted
  // Predicates that it writes, a bit each; of PLOP3 without inputs the value that all of them get, else -1.
  std::uint8_t predicates_written = 0;
  std::int8_t constant_predicate = -1;
  std::uint8_t barrier = 0;  // of open, meet, leave, save and restore
  std::uint8_t reg = 0;      // of save and restore
  std::uint32_t target = no_target;
  // Registers by number; of forms with an immediate operand (bits 9 to 11 are 4), its value.
  std::uint8_t destination = 0, source = 0;
  bool has_immediate = false;
  std::int32_t immediate = 0;
  // Of a load from the constant banks: which, and where in it; bank 0xFF of others.
  std::uint8_t constant_bank = 0xFF;
  std::uint32_t constant_offset = 0;
  InstructionClass instruction_class = InstructionClass::other;
  bool special_function = false;  // issued to the pipe that ncu calls xu

  // Whether not all lanes that come to it need do it.
  bool is_conditional() const {
    return guard != always || guard_negated || condition != always || condition_negated;
  }
};

// "BRA", without modifiers; "?" for an opcode that is not known.
std::string_view mnemonic(const Instruction& instruction);

}  // namespace warpgrain::profiler::sass
